#include "ui/views/source/source_view.h"

#include "ui/document/message_text.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/icons.h"

#include <QAccessible>
#include <QClipboard>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>

#include <algorithm>

namespace knittsim::ui {

SourceView::SourceView(document::Document& document, QWidget* parent)
    : QAbstractScrollArea(parent), m_document(document) {
    setObjectName(QStringLiteral("sourceView"));
    setAccessibleName(tr("Source text"));
    setFocusPolicy(Qt::StrongFocus);
    setFrameShape(QFrame::NoFrame);
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    connect(&m_document, &document::Document::fileChanged, this, &SourceView::takeFile);
    connect(&m_document, &document::Document::selectionChanged, this, &SourceView::takeSelection);
    connect(&m_document, &document::Document::stepChanged, this, &SourceView::takeSelection);
    connect(&m_document, &document::Document::problemsChanged, this, [this] {
        m_problems.clear();
        for (const Diagnostic& problem : m_document.problems()) {
            int& worst = m_problems[problem.place.line];
            worst = std::max(worst, static_cast<int>(problem.severity));
        }
        viewport()->update();
    });
    takeFile();
}

void SourceView::takeFile() {
    m_failed = false;
    m_text = m_document.file() ? m_document.file()->source : nullptr;
    layoutText();
    verticalScrollBar()->setValue(0);
    takeSelection();
}

void SourceView::takeSelection() {
    const auto file = m_document.file();
    if (!file) {
        return;
    }
    if (m_document.selection().line > 0) {
        showOpenFile();
    }
    const auto step = static_cast<std::size_t>(m_document.step());
    const auto& operations = file->timeline->program().operations;
    m_stepLine = step > 0 && step <= operations.size() ? operations[step - 1].line : -1;
    if (!m_failed) {
        goToLine(m_document.selection().line);
    }
}

void SourceView::showOpenFile() {
    if (m_failed) {
        m_failed = false;
        m_text = m_document.file()->source;
        layoutText();
    }
}

void SourceView::showLine(int line) {
    showOpenFile();
    goToLine(line);
}

void SourceView::showProblemLine(int line) {
    const auto failed = m_document.failedFile();
    if (!failed) {
        m_document.selectLine(line);
        goToLine(line);
        return;
    }
    m_failed = true;
    m_text = failed->source;
    layoutText();
    goToLine(line);
}

void SourceView::goToLine(int line) {
    m_line = line;
    if (line > 0) {
        const int page = std::max(1, viewport()->height() / lineHeight());
        QScrollBar* bar = verticalScrollBar();
        if (line - 1 < bar->value() + 1 || line > bar->value() + page - 1) {
            bar->setValue(line - 1 - page / 2);
        }
        if (m_text) {
            setAccessibleDescription(tr("Line %1: %2").arg(line).arg(m_text->line(line)));
            QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
            QAccessible::updateAccessibility(&changed);
        }
    }
    viewport()->update();
}

int SourceView::lineHeight() const {
    return fontMetrics().height() + 2;
}

int SourceView::marginWidth() const {
    const int digits =
        std::max(3, static_cast<int>(QString::number(m_text ? m_text->lineCount() : 0).size()));
    return fontMetrics().horizontalAdvance(QString(digits, u'8')) + lineHeight() + 12;
}

void SourceView::layoutText() {
    const int lines = m_text ? m_text->lineCount() : 0;
    const int page = std::max(1, viewport()->height() / lineHeight());
    verticalScrollBar()->setRange(0, std::max(0, lines - page));
    verticalScrollBar()->setPageStep(page);
    const int width = fontMetrics().averageCharWidth() * ((m_text ? m_text->longestLine() : 0) + 2);
    const int area = viewport()->width() - marginWidth();
    horizontalScrollBar()->setRange(0, std::max(0, width - area));
    horizontalScrollBar()->setPageStep(std::max(1, area));
    horizontalScrollBar()->setSingleStep(fontMetrics().averageCharWidth() * 4);
    viewport()->update();
}

int SourceView::lineAt(int y) const {
    return verticalScrollBar()->value() + y / lineHeight() + 1;
}

void SourceView::paintLine(QPainter& painter, int number, const QRect& rect) const {
    const QString line = m_text->line(number).toString();
    const qsizetype comment = line.indexOf(u';');
    const QString code = comment < 0 ? line : line.left(comment);
    const qsizetype blank = code.indexOf(u' ');
    const QString operation = blank < 0 ? code : code.left(blank);
    const Accents accents = accentsOf(palette());
    const auto draw = [&](const QString& text, qsizetype before, const QColor& colour) {
        painter.setPen(colour);
        painter.drawText(rect.translated(fontMetrics().horizontalAdvance(line.left(before)), 0),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, text);
    };
    draw(operation, 0, palette().color(QPalette::Link));
    draw(code.mid(operation.size()), operation.size(), palette().color(QPalette::Text));
    if (comment >= 0) {
        draw(line.mid(comment), comment, accents.faintText);
    }
}

void SourceView::paintMargin(QPainter& painter, int number, const QRect& rect) const {
    const Accents accents = accentsOf(palette());
    const bool strong = number == m_line;
    QFont face = font();
    face.setBold(strong);
    painter.setFont(face);
    painter.setPen(strong ? palette().color(QPalette::WindowText) : accents.faintText);
    painter.drawText(rect.adjusted(lineHeight(), 0, -8, 0), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(number));
    painter.setFont(font());
    const QRect mark(rect.left() + 2, rect.top() + 1, lineHeight() - 2, lineHeight() - 2);
    const bool ofShownFile = m_failed == (m_document.failedFile() != nullptr);
    if (ofShownFile && m_problems.contains(number)) {
        const bool error = m_problems.value(number) == static_cast<int>(Severity::Error);
        icon(error ? QStringLiteral("error") : QStringLiteral("warning"),
             error ? accents.error : accents.warning)
            .paint(&painter, mark);
    } else if (!m_failed && number == m_stepLine) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(palette().color(QPalette::Highlight));
        painter.setRenderHint(QPainter::Antialiasing);
        const QPointF middle(mark.center());
        const double size = mark.width() * 0.28;
        painter.drawPolygon(QPolygonF(
            {middle + QPointF(-size, -size), middle + QPointF(size, 0), middle + QPointF(-size, size)}));
    }
}

void SourceView::paintEvent(QPaintEvent*) {
    QPainter painter(viewport());
    painter.fillRect(viewport()->rect(), palette().color(QPalette::Base));
    if (!m_text || m_text->lineCount() == 0) {
        painter.setFont(QGuiApplication::font());
        painter.setPen(accentsOf(palette()).faintText);
        painter.drawText(viewport()->rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                         m_failed ? tr("This file is not text.") : tr("No text to show."));
        return;
    }
    const int margin = marginWidth();
    const int last = std::min(m_text->lineCount(), lineAt(viewport()->height()));
    painter.setClipRect(margin, 0, viewport()->width() - margin, viewport()->height());
    for (int number = lineAt(0); number <= last; ++number) {
        const int top = (number - lineAt(0)) * lineHeight();
        if (number == m_line) {
            QColor band = palette().color(QPalette::Highlight);
            band.setAlphaF(0.20F);
            painter.fillRect(0, top, viewport()->width(), lineHeight(), band);
        }
        paintLine(painter, number,
                  {margin + 6 - horizontalScrollBar()->value(), top, viewport()->width() * 4, lineHeight()});
    }
    painter.setClipping(false);
    painter.fillRect(0, 0, margin, viewport()->height(), palette().color(QPalette::Window));
    for (int number = lineAt(0); number <= last; ++number) {
        paintMargin(painter, number, {0, (number - lineAt(0)) * lineHeight(), margin, lineHeight()});
    }
    painter.setPen(accentsOf(palette()).line);
    painter.drawLine(margin - 1, 0, margin - 1, viewport()->height());
}

void SourceView::resizeEvent(QResizeEvent*) {
    layoutText();
}

void SourceView::selectLine(int line) {
    if (!m_text || line < 1 || line > m_text->lineCount()) {
        return;
    }
    if (m_failed) {
        goToLine(line);
    } else {
        m_document.selectLine(line);
    }
}

void SourceView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        selectLine(lineAt(static_cast<int>(event->position().y())));
    }
}

void SourceView::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy) && m_text && m_line > 0) {
        QGuiApplication::clipboard()->setText(m_text->line(m_line).toString());
    } else if (event->key() == Qt::Key_Up && event->modifiers() == Qt::NoModifier) {
        selectLine(m_line - 1);
    } else if (event->key() == Qt::Key_Down && event->modifiers() == Qt::NoModifier) {
        selectLine(m_line + 1);
    } else {
        QAbstractScrollArea::keyPressEvent(event);
    }
}

bool SourceView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool walks = key->key() == Qt::Key_Up || key->key() == Qt::Key_Down;
        if ((walks && key->modifiers() == Qt::NoModifier) || key->matches(QKeySequence::Copy)) {
            event->accept();
            return true;
        }
    }
    return QAbstractScrollArea::event(event);
}

bool SourceView::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QStringList texts;
        for (const Diagnostic& problem : m_document.problems()) {
            if (problem.place.line == lineAt(help->pos().y())) {
                texts << document::causeText(problem);
            }
        }
        QToolTip::showText(help->globalPos(), texts.join(u'\n'), viewport());
        return true;
    }
    return QAbstractScrollArea::viewportEvent(event);
}

void SourceView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) {
        layoutText();
    }
    QAbstractScrollArea::changeEvent(event);
}

} // namespace knittsim::ui
