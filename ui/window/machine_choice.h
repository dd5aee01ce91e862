#pragma once

#include "ui/document/document.h"

#include <QComboBox>

namespace knittsim::ui {

/// The machine that the program is emulated on: as the file says (and what that is), one of the library or of
/// the user's own, or "Add machine...".
class MachineChoice : public QComboBox {
    Q_OBJECT

public:
    explicit MachineChoice(document::Document& document, QWidget* parent = nullptr);

    /// Reads the profiles again. Their faults, if any.
    Diagnostics reload();

signals:
    void addWanted();

private:
    void choose(int index);
    void show();

    document::Document& m_document;
};

} // namespace knittsim::ui
