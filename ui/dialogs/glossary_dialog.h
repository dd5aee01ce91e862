#pragma once

#include "ui/dialogs/glossary.h"
#include "ui/document/document.h"

#include <QDialog>
#include <QTimer>

class QLabel;
class QListWidget;

namespace knittsim::ui {

class NeedleBeds;

/// Words of machine knitting, each with needles that show it again and again.
class GlossaryDialog : public QDialog {
    Q_OBJECT

public:
    explicit GlossaryDialog(QWidget* parent = nullptr);
    ~GlossaryDialog() override;

    void showWord(const QString& id);
    QString shownWord() const;
    NeedleBeds& stage() { return *m_stage; }
    document::Document& document() { return m_document; }

private:
    void showRow(int row);
    void next();

    std::vector<GlossaryEntry> m_entries = glossary();
    document::Document m_document; ///< of the tiny program
    QTimer m_timer;
    int m_row = -1;
    QListWidget* m_list = nullptr;
    QLabel* m_word = nullptr;
    QLabel* m_text = nullptr;
    NeedleBeds* m_stage = nullptr;
};

} // namespace knittsim::ui
