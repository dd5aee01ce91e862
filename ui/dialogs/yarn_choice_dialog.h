#pragma once

#include "ui/document/document.h"

#include <QDialog>

class QComboBox;
class QLabel;

namespace knittsim::ui {

/// Asks for a yarn of the library, on one carrier or on all.
class YarnChoiceDialog : public QDialog {
    Q_OBJECT

public:
    explicit YarnChoiceDialog(const document::Document& document, QWidget* parent = nullptr);

signals:
    void chosen(int carrier, const knittsim::yarn::Yarn& yarn); ///< carrier -1: all

private:
    void takeYarn();

    const document::Document& m_document;
    std::vector<yarn::Yarn> m_yarns;
    QComboBox* m_carrier;
    QComboBox* m_yarn;
    QLabel* m_facts;
};

} // namespace knittsim::ui
