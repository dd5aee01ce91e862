#include "ui/window/sample_card.h"

#include "core/pattern/samples.h"
#include "ui/views/style/appearance.h"
#include "ui/window/sample_thumbnail.h"

#include <QCoreApplication>
#include <QPainter>
#include <QTextLayout>

namespace knittsim::ui {

namespace {

constexpr int kPictureHeight = 104;
constexpr int kMargin = 10;

/// At most `lines` lines of wrapped text; the last one is elided.
void drawWrapped(QPainter& painter, const QRect& rect, const QString& text, int lines) {
    QTextLayout layout(text, painter.font());
    layout.beginLayout();
    const QFontMetrics metrics = painter.fontMetrics();
    int y = rect.top();
    for (int i = 0; i < lines; ++i) {
        QTextLine line = layout.createLine();
        if (!line.isValid()) {
            break;
        }
        line.setLineWidth(rect.width());
        const QString part =
            i + 1 < lines ? text.mid(line.textStart(), line.textLength()).trimmed()
                          : metrics.elidedText(text.mid(line.textStart()), Qt::ElideRight, rect.width());
        painter.drawText(rect.left(), y + metrics.ascent(), part);
        y += metrics.height();
    }
    layout.endLayout();
}

} // namespace

QString sampleTitle(const pattern::Sample& sample) {
    return QCoreApplication::translate("samples", sample.title.c_str());
}

QString sampleDescription(const pattern::Sample& sample) {
    return QCoreApplication::translate("samples", sample.description.c_str());
}

SampleCard::SampleCard(const pattern::Sample& sample, QWidget* parent)
    : QAbstractButton(parent), m_id(QString::fromStdString(sample.id)),
      m_description(sampleDescription(sample)) {
    setObjectName(QStringLiteral("sample_") + m_id);
    setText(sampleTitle(sample));
    setToolTip(m_description);
    setAccessibleDescription(m_description);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
}

void SampleCard::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool hot = underMouse() || hasFocus();
    const Accents accents = accentsOf(palette());
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(QPen(hot ? palette().color(QPalette::Highlight) : accents.line, hot ? 1.6 : 1));
    painter.setBrush(palette().color(isDown() ? QPalette::AlternateBase : QPalette::Base));
    painter.drawRoundedRect(frame, 7, 7);

    const QRectF picture(kMargin, kMargin, width() - 2 * kMargin, kPictureHeight);
    const double ratio = devicePixelRatioF();
    if (m_picture.isNull() || m_picture.deviceIndependentSize() != picture.size()) {
        m_picture = QPixmap((picture.size() * ratio).toSize());
        m_picture.setDevicePixelRatio(ratio);
        m_picture.fill(Qt::transparent);
        QPainter drawing(&m_picture);
        paintChartThumbnail(drawing, QRectF(QPointF(0, 0), picture.size()),
                            pattern::sampleChart(m_id.toStdString()));
    }
    painter.drawPixmap(picture.topLeft(), m_picture);

    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(palette().color(QPalette::WindowText));
    const int line = painter.fontMetrics().height();
    const int top = static_cast<int>(picture.bottom()) + 7;
    painter.drawText(QRect(kMargin, top, width() - 2 * kMargin, line), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text(), Qt::ElideRight, width() - 2 * kMargin));
    painter.setFont(font());
    painter.setPen(accents.faintText);
    drawWrapped(painter, {kMargin, top + line + 2, width() - 2 * kMargin, 3 * line}, m_description, 3);
}

void SampleCard::enterEvent(QEnterEvent*) {
    update();
}
void SampleCard::leaveEvent(QEvent*) {
    update();
}

} // namespace knittsim::ui
