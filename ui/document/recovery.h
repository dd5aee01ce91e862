#pragma once

#include "core/pattern/project.h"

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>
#include <vector>

class QLockFile;

namespace knittsim::document {

class Document;

/// Keeps a copy of a chart with unsaved changes, so that not more than a few seconds are lost when the
/// program or the machine dies: a project file in the folder `recovery` beside the settings, written as a
/// whole a few seconds after the first change that it lacks (500 x 500 stitches take some ten milliseconds).
/// It goes when the chart is saved, left or undone. A lock file tells other running programs whose it is.
class Recovery : public QObject {
    Q_OBJECT

public:
    static constexpr int kDelayMs = 3000;

    explicit Recovery(Document& document);
    ~Recovery() override;

    /// What a program that died has left behind.
    struct Leftover {
        QString path;
        QString title;
        QDateTime time;
    };
    static std::vector<Leftover> leftovers();
    static void discard(const Leftover& leftover);

    static QString folder();

    void write(); ///< now, where there are unsaved changes

private:
    void takeChange();
    void remove();

    Document& m_document;
    QTimer m_timer;
    QString m_id;
    QString m_path; ///< of the copy; empty while there is none
    std::unique_ptr<QLockFile> m_lock;
};

} // namespace knittsim::document
