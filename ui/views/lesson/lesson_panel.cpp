#include "ui/views/lesson/lesson_panel.h"

#include "core/base/file.h"
#include "core/base/json_places.h"
#include "core/base/resources.h"
#include "core/pattern/samples.h"
#include "ui/views/style/icons.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <string>
#include <utility>

namespace knittsim::ui {

namespace {

QString inWords(const lesson::Words& words) {
    return QString::fromStdString(words.in(QLocale().name().toStdString()));
}

QToolButton* makeButton(QWidget* parent, const char* name, const char* iconName, const QString& text,
                        const QString& help) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QString::fromLatin1(name));
    button->setIcon(icon(QString::fromLatin1(iconName)));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setText(text);
    button->setToolTip(help);
    button->setAccessibleName(text);
    return button;
}

/// What is wrong with the name of a sample, with its line.
Diagnostics unknownSample(const lesson::Lesson& lesson, const std::string& path) {
    std::string known;
    for (const pattern::Sample& sample : pattern::samples()) {
        known += (known.empty() ? "one of " : ", ") + std::string(sample.id);
        if (lesson.sample.empty() || lesson.sample == sample.id) {
            return {};
        }
    }
    Diagnostics problems{
        {"KS0004", Severity::Error, Place{.file = path}, {"sample", '"' + lesson.sample + '"', known}}};
    if (const auto text = readFile(path)) {
        tellLines(text.value(), problems);
    }
    return problems;
}

} // namespace

LessonPanel::LessonPanel(document::Document& document, QWidget* parent)
    : QWidget(parent), m_document(document) {
    setObjectName(QStringLiteral("lessonPanel"));
    setAccessibleName(tr("Lesson"));
    Diagnostics problems; // of files that come along: a test reads them
    m_lessons = lesson::readLessons(resourceFolder() / "lessons", problems);
    m_choice = new QComboBox(this);
    m_choice->setObjectName(QStringLiteral("lessonChoice"));
    m_choice->setAccessibleName(tr("Lessons"));
    m_choice->setToolTip(tr("Begins a lesson"));
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_choice->setMinimumContentsLength(12);
    auto* open = makeButton(this, "lessonOpen", "open", {}, tr("Opens a lesson of your own (JSON)"));
    open->setToolButtonStyle(Qt::ToolButtonIconOnly);
    open->setAccessibleName(tr("Open a lesson"));
    m_title = new QLabel(this);
    m_title->setObjectName(QStringLiteral("lessonTitle"));
    m_title->setWordWrap(true);
    m_text = new QLabel(this);
    m_text->setObjectName(QStringLiteral("lessonText"));
    m_text->setWordWrap(true);
    m_text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* area = new QScrollArea(this);
    area->setWidget(m_text);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    m_back = makeButton(this, "stopBack", "back", tr("Back"), tr("To the stop before (Page Up)"));
    m_next = makeButton(this, "stopNext", "forward", tr("Next"), tr("To the next stop (Page Down)"));
    m_place = new QLabel(this);
    m_place->setToolTip(tr("Stop of the lesson"));
    m_place->setAlignment(Qt::AlignCenter);

    auto* top = new QHBoxLayout;
    top->addWidget(m_choice, 1);
    top->addWidget(open);
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(m_back);
    bottom->addWidget(m_place, 1);
    bottom->addWidget(m_next);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(10, 8, 10, 8);
    rows->addLayout(top);
    rows->addWidget(m_title);
    rows->addWidget(area, 1);
    rows->addLayout(bottom);

    connect(m_choice, &QComboBox::activated, this, [this](int row) { begin(row - 1); });
    connect(open, &QToolButton::clicked, this, &LessonPanel::openWanted);
    connect(m_back, &QToolButton::clicked, this, [this] { moveStop(-1); });
    connect(m_next, &QToolButton::clicked, this, [this] { moveStop(+1); });
    // Whatever is opened next takes the place of a lesson's program that is under way, also of a cancelled
    // one.
    connect(&m_document, &document::Document::openingStarted, this, [this] { m_pending = m_asked; });
    connect(&m_document, &document::Document::openFailed, this, [this] { m_pending.reset(); });
    connect(&m_document, &document::Document::lifted, this, [this] {
        m_pending.reset();
        if (running()) {
            end(); // the chart has a program of its own
        }
    });
    listLessons();
    showText();
    scale();
}

/// Letters that are read from the back of the room.
void LessonPanel::scale() {
    constexpr int kLinesOfWindow = 40;
    QFont large = font();
    large.setPixelSize(std::max(window()->height() / kLinesOfWindow, 3 * fontMetrics().ascent() / 2));
    m_text->setFont(large);
    large.setBold(true);
    m_title->setFont(large);
}

void LessonPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    scale();
}

void LessonPanel::listLessons() {
    const QSignalBlocker quiet(m_choice);
    m_choice->clear();
    m_choice->addItem(tr("Choose a lesson"));
    for (const lesson::Lesson& lesson : m_lessons) {
        m_choice->addItem(inWords(lesson.title));
        m_choice->setItemData(m_choice->count() - 1, inWords(lesson.summary), Qt::ToolTipRole);
    }
    const auto row =
        m_lesson ? std::ranges::find(m_lessons, m_lesson->id, &lesson::Lesson::id) : m_lessons.end();
    m_choice->setCurrentIndex(row == m_lessons.end() ? 0 : static_cast<int>(row - m_lessons.begin()) + 1);
}

void LessonPanel::begin(int index) {
    if (index < 0 || index >= static_cast<int>(m_lessons.size())) {
        return;
    }
    m_asked = m_lessons[static_cast<std::size_t>(index)];
    if (m_asked->sample.empty()) {
        emit programWanted(QString::fromStdString(m_asked->file.string()));
    } else {
        emit sampleWanted(QString::fromStdString(m_asked->sample));
    }
    m_asked.reset();
    listLessons(); // the person may have declined
}

Diagnostics LessonPanel::openFile(const QString& path) {
    auto lesson = lesson::readLesson(path.toStdString());
    if (!lesson) {
        return lesson.diagnostics();
    }
    if (Diagnostics problems = unknownSample(lesson.value(), path.toStdString()); !problems.empty()) {
        return problems;
    }
    std::erase_if(m_lessons, [&](const lesson::Lesson& old) { return old.id == lesson->id; });
    m_lessons.push_back(std::move(lesson).value());
    begin(static_cast<int>(m_lessons.size()) - 1);
    return {};
}

/// The file that is open is the program of a lesson.
bool LessonPanel::opens(const lesson::Lesson& lesson) const {
    const auto file = m_document.file();
    if (!file) {
        return false;
    }
    const document::OpenRequest& request = file->request;
    if (lesson.sample.empty()) {
        return request.path == QString::fromStdString(lesson.file.string());
    }
    return request.path.isEmpty() && request.project &&
           request.project->chart == pattern::sampleChart(lesson.sample);
}

void LessonPanel::takeProgram() {
    std::optional<lesson::Lesson> begins = std::exchange(m_pending, std::nullopt);
    if (!begins || !opens(*begins)) {
        end();
        return;
    }
    m_lesson = std::move(begins);
    m_stop = -1;
    listLessons();
    emit begun();
    showStop(0);
    emit runningChanged();
}

void LessonPanel::end() {
    m_lesson.reset();
    m_stop = -1;
    listLessons();
    showText();
    emit runningChanged();
}

std::vector<machine::OperationIndex> LessonPanel::stopSteps() const {
    std::vector<machine::OperationIndex> steps;
    const auto file = m_document.file();
    if (current() && file) {
        for (const lesson::Stop& stop : current()->stops) {
            steps.push_back(lesson::stepOf(stop.at, file->timeline->program(), file->courseEnds));
        }
    }
    return steps;
}

QString LessonPanel::title() const {
    return current() ? inWords(current()->title) : QString();
}

QString LessonPanel::textOf(int stop) const {
    const lesson::Stop& at = current()->stops[static_cast<std::size_t>(stop)];
    return inWords(at.title) + u'\n' + inWords(at.text);
}

void LessonPanel::showStop(int stop) {
    if (!current() || stop < 0 || stop >= static_cast<int>(current()->stops.size())) {
        return;
    }
    m_stop = stop;
    m_document.setStep(stopSteps()[static_cast<std::size_t>(stop)]);
    showText();
    emit stopShown(current()->stops[static_cast<std::size_t>(stop)].look);
}

void LessonPanel::showText() {
    const bool shows = running() && m_stop >= 0;
    const auto count = shows ? static_cast<int>(current()->stops.size()) : 0;
    m_title->setVisible(shows);
    m_title->setText(shows ? inWords(current()->stops[static_cast<std::size_t>(m_stop)].title) : QString());
    m_text->setText(shows ? inWords(current()->stops[static_cast<std::size_t>(m_stop)].text)
                          : tr("A lesson opens its own program and stops where there is something to see."));
    m_place->setText(shows ? tr("%1 of %2").arg(m_stop + 1).arg(count) : QString());
    m_back->setEnabled(shows && m_stop > 0);
    m_next->setEnabled(shows && m_stop + 1 < count);
}

} // namespace knittsim::ui
