#pragma once

#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "core/lesson/lesson.h"
#endif

#include "ui/document/document.h"

#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QToolButton;

namespace knittsim::ui {

/// Leads through a lesson: where the class is, what is said there, on to the next stop and back.
class LessonPanel : public QWidget {
    Q_OBJECT

public:
    explicit LessonPanel(document::Document& document, QWidget* parent = nullptr);

    const std::vector<lesson::Lesson>& lessons() const { return m_lessons; }
    /// Begins one of lessons(): its program is asked for, and shown at the first stop once it is open. Until
    /// then, and where the program does not come, the lesson that runs goes on.
    void begin(int index);
    /// A lesson of one's own is listed and begun. Says what is wrong with it otherwise.
    Diagnostics openFile(const QString& path);

    /// Another program is open, and the window shows it.
    void takeProgram();

    bool running() const { return m_lesson.has_value(); }
    int stop() const { return m_stop; }
    void moveStop(int direction) { showStop(m_stop + direction); }
    /// The lesson that runs, or null.
    const lesson::Lesson* current() const { return m_lesson ? &*m_lesson : nullptr; }
    /// Operations done at each stop of the lesson that runs.
    std::vector<machine::OperationIndex> stopSteps() const;
    QString title() const;          ///< of the lesson that runs
    QString textOf(int stop) const; ///< title and text in the person's language

    QSize sizeHint() const override { return {320, 300}; }

protected:
    void resizeEvent(QResizeEvent* event) override;

signals:
    void sampleWanted(const QString& id);
    void programWanted(const QString& path);
    void openWanted();
    void begun(); ///< the program of the lesson is open
    void stopShown(knittsim::lesson::Look look);
    void runningChanged();

private:
    bool opens(const lesson::Lesson& lesson) const;
    void end();
    void listLessons();
    void showStop(int stop);
    void showText();
    void scale();

    document::Document& m_document;
    std::vector<lesson::Lesson> m_lessons;
    // Copies, for the list changes.
    std::optional<lesson::Lesson> m_lesson;  ///< runs
    std::optional<lesson::Lesson> m_asked;   ///< while its program is asked for
    std::optional<lesson::Lesson> m_pending; ///< its program is being opened
    int m_stop = -1;
    QComboBox* m_choice = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_text = nullptr;
    QLabel* m_place = nullptr;
    QToolButton* m_back = nullptr;
    QToolButton* m_next = nullptr;
};

} // namespace knittsim::ui
