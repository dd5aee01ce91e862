#pragma once

#include "ui/document/document.h"
#include "ui/views/step_player/playback.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace knittsim::ui {

/// Bar below the fabric. Keys are given by the window, so that they work everywhere in it.
class StepPlayer : public QWidget {
    Q_OBJECT

public:
    explicit StepPlayer(document::Document& document, QWidget* parent = nullptr);

    bool isPlaying() const { return m_timer.isActive(); }
    void setPlaying(bool on);
    void togglePlaying() { setPlaying(!isPlaying()); }
    double speed() const { return m_playback.speed(); } ///< operations a second
    void setSpeed(double operationsPerSecond);
    void changeSpeed(int direction);

    /// For a class room: the operation in words can be read from the last row.
    void setLargeWords(bool on);

signals:
    void playingChanged(bool on);
    void speedChanged(double operationsPerSecond);

private:
    void build();
    QToolButton* addButton(const char* name, const char* iconName, const QString& text, const QString& keys);
    void takeFile();
    void takeStep();
    void tick();
    void showSpeed();
    bool event(QEvent* event) override;

    document::Document& m_document;
    Playback m_playback;
    QTimer m_timer;
    QElapsedTimer m_sinceTick;
    QSlider* m_slider = nullptr;
    QToolButton* m_play = nullptr;
    QComboBox* m_speed = nullptr;
    QLabel* m_words = nullptr;
    QLabel* m_count = nullptr;
};

} // namespace knittsim::ui
