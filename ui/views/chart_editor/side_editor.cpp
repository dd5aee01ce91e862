#include "ui/views/chart_editor/side_editor.h"

#include "ui/views/style/appearance.h"

#include <QKeyEvent>
#include <QLocale>
#include <QToolTip>

#include <cmath>
#include <utility>

namespace knittsim::ui {

SideEditor::SideEditor(const QRect& place, const QString& text, Range range,
                       std::function<void(std::optional<double>)> taken, QWidget* parent)
    : QLineEdit(text, parent), m_range(range), m_taken(std::move(taken)) {
    setObjectName(QStringLiteral("sideEditor"));
    setAttribute(Qt::WA_DeleteOnClose);
    const QSize size(std::max(place.width(), 46), sizeHint().height());
    setGeometry(QRect(QPoint(place.left(), place.center().y() - size.height() / 2), size));
    selectAll();
    show();
    setFocus();
}

void SideEditor::finish() {
    bool good = false;
    const QString words = text().trimmed();
    double value = words.toDouble(&good);
    if (!good) {
        value = QLocale().toDouble(words, &good);
    }
    good = good && value >= m_range.low && value <= m_range.high &&
           (!m_range.whole || std::floor(value) == value);
    if (words.isEmpty() || good) {
        const auto taken = std::exchange(m_taken, {});
        close();
        if (taken) {
            taken(words.isEmpty() ? std::nullopt : std::optional(value));
        }
        return;
    }
    QPalette colours = palette();
    colours.setColor(QPalette::Text, accentsOf(colours).error);
    setPalette(colours);
    setToolTip((m_range.whole ? tr("A whole number from %1 to %2") : tr("A number from %1 to %2"))
                   .arg(m_range.low)
                   .arg(m_range.high));
    QToolTip::showText(mapToGlobal(rect().bottomLeft()), toolTip(), this);
}

void SideEditor::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        m_taken = {};
        close();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        finish();
    } else {
        QLineEdit::keyPressEvent(event);
    }
}

void SideEditor::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (m_taken && event->reason() != Qt::ActiveWindowFocusReason &&
        event->reason() != Qt::PopupFocusReason) {
        finish();
        if (isVisible()) {
            m_taken = {};
            close();
        }
    }
}

} // namespace knittsim::ui
