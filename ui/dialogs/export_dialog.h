#pragma once

#include "ui/dialogs/export_job.h"

#include <QDialog>
#include <QThreadPool>

#include <atomic>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace knittsim::ui {

/// Asks for a format, a file and what belongs to the format; writes in the background with progress and
/// cancel. Closes when the file is there; says in place what went wrong.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    /// `path`: of a file that does not need to exist, without an extension; `view`: pixels of the view.
    ExportDialog(ExportSource source, const QString& path, QSize view, QWidget* parent = nullptr);
    ~ExportDialog() override;

    void reject() override; ///< cancels the work first

signals:
    void written(const QString& path);

private:
    void takeFormat();
    QString hintFor(const char* hint, bool picture) const;
    void browse();
    void start();
    void finish(const Diagnostics& problems);
    void setWorking(bool working);
    void enableControls();

    ExportSource m_source;
    QComboBox* m_format;
    QLineEdit* m_path;
    QPushButton* m_browse;
    QComboBox* m_side;
    QSpinBox* m_width;
    QSpinBox* m_height;
    QCheckBox* m_transparent;
    QLabel* m_hint;
    QLabel* m_problem;
    QString m_replaced; ///< file that exists and was asked about
    QProgressBar* m_progress;
    QPushButton* m_export;
    QPushButton* m_close;
    bool m_working = false;
    std::atomic<bool> m_cancelled = false;
    QThreadPool m_pool; // last: it waits for its work
};

} // namespace knittsim::ui
