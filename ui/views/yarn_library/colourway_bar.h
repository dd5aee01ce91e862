#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QComboBox;
class QMenu;

namespace knittsim::ui {

/// The colourways of a chart: which one is shown, and what is done with it. Hidden for machine data.
class ColourwayBar : public QWidget {
    Q_OBJECT

public:
    explicit ColourwayBar(document::Document& document, QWidget* parent = nullptr);

    void add(const QString& name);
    void rename(const QString& name); ///< the one in use
    void removeUsed();
    void useNext(); ///< after the last one the first

private:
    void take();
    void use(int index);
    void buildMenu(QMenu* menu);
    QString askName(const QString& title, const QString& name);
    QString nextName() const;

    document::Document& m_document;
    QComboBox* m_choice;
};

} // namespace knittsim::ui
