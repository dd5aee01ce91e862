#include "ui/views/step_player/step_player.h"

#include "ui/document/operation_text.h"
#include "ui/views/step_player/marked_slider.h"
#include "ui/views/step_player/skimming.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/icons.h"
#include "ui/views/style/numbers.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace knittsim::ui {

namespace {

constexpr int kTickMs = 16;

/// Shortens its text at the end instead of demanding room for all of it.
class ElidedLabel : public QLabel {
public:
    using QLabel::QLabel;

    QSize minimumSizeHint() const override { return {60, QLabel::minimumSizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setPen(palette().color(foregroundRole()));
        painter.drawText(contentsRect(), Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width()));
    }
};

} // namespace

StepPlayer::StepPlayer(document::Document& document, QWidget* parent)
    : QWidget(parent), m_document(document) {
    setObjectName(QStringLiteral("stepPlayer"));
    setAccessibleName(tr("Step player"));
    build();
    m_timer.setInterval(kTickMs);
    connect(&m_timer, &QTimer::timeout, this, &StepPlayer::tick);
    connect(&m_document, &document::Document::fileChanged, this, &StepPlayer::takeFile);
    connect(&m_document, &document::Document::opened, &m_marks, &document::StepMarks::clear);
    connect(&m_document, &document::Document::problemsChanged, this, [this] {
        if (const auto file = m_document.file()) {
            m_finder = {file->timeline, m_document.problems()};
        }
    });
    connect(&m_marks, &document::StepMarks::changed, this, &StepPlayer::showMarks);
    connect(&m_document, &document::Document::stepChanged, this, &StepPlayer::takeStep);
    takeFile();
}

QToolButton* StepPlayer::addButton(const char* name, const char* iconName, const QString& text,
                                   const QString& keys) {
    auto* button = new QToolButton(this);
    button->setObjectName(QString::fromLatin1(name));
    button->setIcon(icon(QString::fromLatin1(iconName)));
    button->setIconSize({18, 18});
    button->setAutoRaise(true);
    button->setAutoRepeat(true);
    button->setAutoRepeatDelay(400);
    button->setToolTip(QStringLiteral("%1 (%2)").arg(text, keys));
    button->setAccessibleName(text);
    return button;
}

void StepPlayer::build() {
    auto* first = addButton("stepFirst", "first", tr("To the empty machine"), tr("Home"));
    auto* courseBack =
        addButton("courseBack", "course-back", tr("One course back"), QStringLiteral("\u2193"));
    auto* back = addButton("stepBack", "back", tr("One operation back"), QStringLiteral("\u2190"));
    m_play = addButton("stepPlay", "play", tr("Play the operations"), tr("Space"));
    auto* forward =
        addButton("stepForward", "forward", tr("One operation forward"), QStringLiteral("\u2192"));
    auto* courseForward =
        addButton("courseForward", "course-forward", tr("One course forward"), QStringLiteral("\u2191"));
    auto* last = addButton("stepLast", "last", tr("To the end of the program"), tr("End"));
    m_play->setAutoRepeat(false);

    m_courseSlider = new MarkedSlider(this);
    m_courseSlider->setObjectName(QStringLiteral("courseSlider"));
    m_courseSlider->setAccessibleName(tr("Course"));
    m_courseSlider->setToolTip(tr("Course that is shown (\u2191 and \u2193)"));
    m_courseSlider->setPageStep(5);
    m_slider = new MarkedSlider(this);
    m_slider->setObjectName(QStringLiteral("stepSlider"));
    m_slider->setAccessibleName(tr("Operation in the course"));
    m_slider->setToolTip(
        tr("Operation that is shown, inside the course (\u2190 and \u2192, Shift for a carriage pass)"));
    m_speed = new QComboBox(this);
    m_speed->setObjectName(QStringLiteral("stepSpeed"));
    m_speed->setAccessibleName(tr("Speed"));
    m_speed->setToolTip(tr("1\u00d7 is five operations a second ([ slower, ] faster)"));
    for (const double speed : Playback::speeds()) {
        m_speed->addItem(tr("%1\u00d7").arg(QLocale().toString(speed / Playback::kUnit, 'g', 6)), speed);
    }
    m_words = new ElidedLabel(this);
    m_words->setObjectName(QStringLiteral("stepWords"));
    m_count = new QLabel(this);
    m_count->setObjectName(QStringLiteral("stepCount"));
    m_count->setToolTip(tr("Operations carried out, and operations of the program"));

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(1);
    for (QToolButton* button : {first, courseBack, back, m_play, forward, courseForward, last}) {
        buttons->addWidget(button);
    }
    buildLoopMenu();
    buildBookmarkMenu();
    buildStopMenu();
    m_loopButton = addMenuButton("loopButton", "loop", tr("Play a part again and again"), m_loopMenu);
    QToolButton* bookmarks = addMenuButton("bookmarkButton", "bookmark", tr("Bookmarks"), m_bookmarkMenu);
    m_stopButton = addMenuButton("stopButton", "stop-at", tr("Where playing stops"), m_stopMenu);
    buttons->addSpacing(4);
    buttons->addWidget(m_courseSlider, 3);
    buttons->addWidget(m_slider, 2);
    buttons->addSpacing(4);
    for (QToolButton* button : {m_loopButton, bookmarks, m_stopButton}) {
        buttons->addWidget(button);
    }
    buttons->addWidget(m_speed);
    auto* texts = new QHBoxLayout;
    texts->addWidget(m_words, 1);
    texts->addWidget(m_count);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(6, 6, 6, 6);
    rows->setSpacing(3);
    rows->addLayout(buttons);
    rows->addLayout(texts);

    connect(first, &QToolButton::clicked, this, [this] { m_document.setStep(0); });
    connect(courseBack, &QToolButton::clicked, this, [this] { m_document.moveCourse(-1); });
    connect(back, &QToolButton::clicked, this, [this] { m_document.moveStep(-1); });
    connect(m_play, &QToolButton::clicked, this, &StepPlayer::togglePlaying);
    connect(forward, &QToolButton::clicked, this, [this] { m_document.moveStep(+1); });
    connect(courseForward, &QToolButton::clicked, this, [this] { m_document.moveCourse(+1); });
    connect(last, &QToolButton::clicked, this, [this] { m_document.setStep(m_document.operationCount()); });
    connect(m_slider, &QSlider::valueChanged, this, [this](int value) { m_document.setStep(value); });
    connect(m_courseSlider, &QSlider::valueChanged, this,
            [this](int part) { m_document.setStep(m_courses.end(part)); });
    connect(m_speed, &QComboBox::currentIndexChanged, this,
            [this] { setSpeed(m_speed->currentData().toDouble()); });
    showSpeed();
}

void StepPlayer::showSpeed() {
    const QSignalBlocker quiet(m_speed);
    m_speed->setCurrentIndex(m_speed->findData(m_playback.speed()));
}

void StepPlayer::setSpeed(double operationsPerSecond) {
    m_playback.setSpeed(
        *std::ranges::min_element(Playback::speeds(), {}, [operationsPerSecond](double speed) {
            return std::abs(std::log(speed / operationsPerSecond));
        }));
    showSpeed();
    emit tempoChanged(speed());
}

void StepPlayer::changeSpeed(int direction) {
    Playback next = m_playback;
    next.changeSpeed(direction);
    setSpeed(next.speed());
}

void StepPlayer::setWords(bool on) {
    m_words->setVisible(on);
}

void StepPlayer::takeFile() {
    setPlaying(false);
    const auto file = m_document.file();
    setEnabled(file != nullptr);
    m_courses =
        file ? document::CourseScale(file->courseEnds, m_document.operationCount()) : document::CourseScale();
    m_finder = file ? document::StopFinder(file->timeline, m_document.problems()) : document::StopFinder();
    const QSignalBlocker quiet(m_courseSlider);
    m_courseSlider->setRange(0, m_courses.partCount());
    listCarriers();
    takeStep();
    m_marks.endAt(m_document.operationCount());
    showMarks();
}

void StepPlayer::takeStep() {
    const QSignalBlocker quiet(m_slider);
    const QSignalBlocker quietCourse(m_courseSlider);
    const int step = m_document.step();
    m_courseSlider->setValue(m_courses.partOf(step));
    m_slider->setRange(m_courses.firstNear(step), m_courses.lastNear(step));
    m_slider->setPageStep(std::max(1, (m_slider->maximum() - m_slider->minimum()) / 10));
    m_slider->setValue(step);
    if (!isPlaying()) {
        m_playback.makeDue(); // else a pause in the middle of an operation goes on from there
    }
    const auto file = m_document.file();
    if (!file) {
        m_words->clear();
        m_count->clear();
        return;
    }
    const machine::Program& program = file->timeline->program();
    QString words = tr("Empty machine");
    if (step > 0) {
        words = document::operationSentence(*file->timeline, step - 1);
        const int line = program.operations[static_cast<std::size_t>(step) - 1].line;
        if (line > 0) {
            words = tr("%1 \u00b7 line %2").arg(words).arg(line);
        }
    }
    m_words->setText(words);
    m_words->setToolTip(words);
    m_count->setText(tr("%1 / %2").arg(countText(step), countText(m_document.operationCount())));
}

void StepPlayer::setPlaying(bool on) {
    if (on == isPlaying() || (on && m_document.operationCount() == 0)) {
        return;
    }
    if (on) {
        if (m_document.step() == m_document.operationCount()) {
            m_document.setStep(m_marks.loops() ? m_marks.loopFrom() : 0);
        }
        m_sinceTick.start();
        m_timer.start();
    } else {
        m_timer.stop();
    }
    m_play->setIcon(icon(on ? QStringLiteral("pause") : QStringLiteral("play")));
    emit playingChanged(on);
}

void StepPlayer::tick() {
    if (m_waiting) {
        m_sinceTick.restart();
        return;
    }
    const double passedMs = static_cast<double>(m_sinceTick.nsecsElapsed()) * 1e-6;
    const int due = m_playback.advance(passedMs * haste(m_document.step() - 1));
    m_sinceTick.restart();
    const auto next = m_marks.play(m_finder, m_document.step(), due, m_document.operationCount());
    if (due > 0) {
        emit tempoChanged(speed() * haste(next.step - 1));
    }
    m_document.setStep(next.step);
    if (next.stops) {
        setPlaying(false);
    }
}

/// How much faster than the speed that is set an operation goes.
double StepPlayer::haste(int operation) const {
    const auto file = m_document.file();
    return m_skimming && file ? skimmingHaste(file->timeline->program(), operation, speed()) : 1.0;
}

void StepPlayer::showMarks() {
    const auto part = [this](int step) { return m_courses.partOf(step); };
    std::vector<int> steps(m_marks.bookmarks().begin(), m_marks.bookmarks().end());
    std::vector<int> parts(steps.size());
    std::ranges::transform(steps, parts.begin(), part);
    const bool loops = m_marks.loops();
    m_slider->setMarks(steps, m_marks.loopFrom(), loops ? m_marks.loopTo() : m_marks.loopFrom());
    m_courseSlider->setMarks(parts, loops ? part(m_marks.loopFrom()) : 0, loops ? part(m_marks.loopTo()) : 0);
    listBookmarks();
    takeRules();
    m_loopButton->setChecked(loops);
    m_stopButton->setChecked(!m_marks.rules().empty());
}

bool StepPlayer::event(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        QPalette quiet = m_count->palette();
        quiet.setColor(QPalette::WindowText, accentsOf(palette()).faintText);
        m_count->setPalette(quiet);
    }
    return QWidget::event(event);
}

} // namespace knittsim::ui
