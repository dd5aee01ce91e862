#include "ui/views/lesson/teaching_board.h"

#include "ui/document/course_scale.h"
#include "ui/document/operation_text.h"
#include "ui/views/style/appearance.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace knittsim::ui {

TeachingBoard::TeachingBoard(document::Document& document, QWidget* parent)
    : QWidget(parent), m_document(document) {
    setObjectName(QStringLiteral("teachingBoard"));
    setAccessibleName(tr("Course and operation"));
    setAutoFillBackground(true);
    m_course = new QLabel(this);
    m_course->setObjectName(QStringLiteral("boardCourse"));
    m_course->setToolTip(tr("Course that is knitted, and courses of the program"));
    m_sentence = new QLabel(this);
    m_sentence->setObjectName(QStringLiteral("boardSentence"));
    m_sentence->setToolTip(tr("The operation that is shown"));
    m_sentence->setWordWrap(true);
    m_row = new QHBoxLayout(this);
    m_row->setContentsMargins(16, 6, 16, 6);
    m_row->setSpacing(24);
    m_row->addWidget(m_course);
    m_row->addWidget(m_sentence, 1);
    connect(&m_document, &document::Document::stepChanged, this, &TeachingBoard::takeStep);
    connect(&m_document, &document::Document::fileChanged, this, &TeachingBoard::takeStep);
    scale();
    takeStep();
}

QString TeachingBoard::sentence() const {
    return m_sentence->text();
}

QString TeachingBoard::course() const {
    return m_course->text();
}

void TeachingBoard::takeStep() {
    const auto file = m_document.file();
    if (!file) {
        m_course->clear();
        m_sentence->clear();
        return;
    }
    const int step = m_document.step();
    const auto courses = static_cast<int>(file->courseEnds.size());
    const document::CourseScale scale(file->courseEnds, m_document.operationCount());
    m_course->setText(tr("Row %1 of %2").arg(std::min(scale.partOf(step), courses)).arg(courses));
    m_sentence->setText(step == 0 ? tr("The empty machine.")
                                  : document::operationSentence(*file->timeline, step - 1));
}

/// Letters as high as a part of the window: what the last row of a class reads.
void TeachingBoard::scale() {
    const int high = std::max(window()->height(), 400);
    QFont large = font();
    large.setBold(true);
    large.setPixelSize(high / 18);
    m_course->setFont(large);
    large.setPixelSize(high / 27);
    m_sentence->setFont(large);
    // Beside a chart there is room for the sentence below the course only.
    const bool narrow = width() < 22 * large.pixelSize();
    m_row->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    m_row->setSpacing(narrow ? 2 : 24);
    const QFontMetrics metrics(large);
    m_sentence->setMinimumHeight(2 * metrics.lineSpacing() + 4); // so that nothing jumps
    const bool dark = isDark(window()->palette());
    QPalette sharp = palette();
    sharp.setColor(QPalette::Window, dark ? Qt::black : Qt::white);
    sharp.setColor(QPalette::WindowText, dark ? Qt::white : Qt::black);
    if (sharp != palette()) {
        setPalette(sharp);
    }
}

void TeachingBoard::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    scale();
}

void TeachingBoard::changeEvent(QEvent* event) {
    if (event->type() == QEvent::ParentChange || event->type() == QEvent::PaletteChange) {
        scale();
    }
    QWidget::changeEvent(event);
}

} // namespace knittsim::ui
