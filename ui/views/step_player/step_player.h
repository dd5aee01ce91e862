#pragma once

#ifndef Q_MOC_RUN // moc 6.4 does not read all headers of C++20
#include "ui/document/course_scale.h"
#include "ui/document/step_marks.h"
#endif

#include "ui/document/document.h"
#include "ui/views/step_player/playback.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QMenu;
class QToolButton;

namespace knittsim::ui {

class MarkedSlider;

/// Bar below the fabric. Keys are given by the window, so that they work everywhere in it.
class StepPlayer : public QWidget {
    Q_OBJECT

public:
    explicit StepPlayer(document::Document& document, QWidget* parent = nullptr);

    bool isPlaying() const { return m_timer.isActive(); }
    void setPlaying(bool on);
    void togglePlaying() { setPlaying(!isPlaying()); }
    double speed() const { return m_playback.speed(); } ///< operations a second
    void setSpeed(double operationsPerSecond);          ///< the nearest that can be chosen
    /// What comes again and again goes faster than what is new.
    void setSkimming(bool on) { m_skimming = on; }
    void changeSpeed(int direction);

    document::StepMarks& marks() { return m_marks; }
    const document::StepMarks& marks() const { return m_marks; }
    /// What can be marked, for the window's menu; with keys.
    std::vector<QMenu*> menus() const { return {m_loopMenu, m_bookmarkMenu, m_stopMenu}; }
    void walkBookmarks(int direction);
    /// To the first operation written on a line of the source or after it.
    void goToLine(int line);
    void askForLine();

    /// Playing waits, for example until a sentence is spoken.
    void setWaiting(bool on) { m_waiting = on; }

    /// The operation in words below the buttons.
    void setWords(bool on);

signals:
    void rulesShown(); ///< the stop menu shows marks().rules() now
    void playingChanged(bool on);
    void tempoChanged(double operationsPerSecond); ///< of the next operation

private:
    void build();
    QToolButton* addButton(const char* name, const char* iconName, const QString& text, const QString& keys);
    void takeFile();
    void takeStep();
    void tick();
    double haste(int operation) const;
    void showSpeed();
    void showMarks();

    // step_player_menus.cpp
    QAction* add(QMenu* menu, const char* name, const QString& text, const QKeySequence& keys,
                 const std::function<void()>& action);
    QToolButton* addMenuButton(const char* name, const char* iconName, const QString& text, QMenu* menu);
    void buildLoopMenu();
    void buildBookmarkMenu();
    void buildStopMenu();
    void listBookmarks();
    void listCarriers();
    void takeRules();
    void addStop(const QString& text, const std::function<void(document::StopRules&, bool)>& set,
                 const std::function<bool(const document::StopRules&)>& get, QMenu* menu = nullptr);
    void askForNeedle();
    void takeNeedle(const QString& text);

    bool event(QEvent* event) override;

    document::Document& m_document;
    Playback m_playback;
    QTimer m_timer;
    QElapsedTimer m_sinceTick;
    bool m_waiting = false;
    bool m_skimming = false;
    document::StepMarks m_marks;
    document::StopFinder m_finder;
    document::CourseScale m_courses;
    MarkedSlider* m_courseSlider = nullptr;
    MarkedSlider* m_slider = nullptr; ///< inside the course
    QMenu* m_loopMenu = nullptr;
    QMenu* m_bookmarkMenu = nullptr;
    QMenu* m_stopMenu = nullptr;
    QMenu* m_carrierMenu = nullptr;
    QToolButton* m_stopButton = nullptr;
    QToolButton* m_loopButton = nullptr;
    std::vector<QAction*> m_bookmarkActions;
    QAction* m_needleStop = nullptr;
    QToolButton* m_play = nullptr;
    QComboBox* m_speed = nullptr;
    QLabel* m_words = nullptr;
    QLabel* m_count = nullptr;
};

} // namespace knittsim::ui
