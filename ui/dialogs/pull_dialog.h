#pragma once

#include "ui/document/document.h"
#include "ui/document/pull_run.h"

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace knittsim::ui {

class PullPlot;

/// Draws a repeat of the open fabric longer and back while a plot grows; writes the points as CSV.
class PullDialog : public QDialog {
    Q_OBJECT

public:
    /// The document must outlive it.
    PullDialog(document::Document& document, QWidget* parent = nullptr);

    const document::PullRun& run() const { return m_run; }
    /// False where the file cannot be written; it is never half written.
    bool writeCsv(const QString& path) const;

private:
    void build();
    void toggle();
    void takeRun();
    void chooseFile();
    QString stateText() const;

    document::Document& m_document;
    document::PullRun m_run;
    QComboBox* m_sides = nullptr;
    QDoubleSpinBox* m_strain = nullptr;
    QSpinBox* m_steps = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_save = nullptr;
    QProgressBar* m_progress = nullptr;
    QLabel* m_state = nullptr;
    PullPlot* m_plot = nullptr;
};

} // namespace knittsim::ui
