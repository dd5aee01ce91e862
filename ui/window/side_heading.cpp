#include "ui/window/side_heading.h"

#include "ui/views/style/appearance.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

namespace knittsim::ui {

SideHeading::SideHeading(QWidget* parent)
    : QWidget(parent), m_title(new QLabel(this)), m_size(new QLabel(this)), m_row(new QHBoxLayout(this)) {
    m_title->setObjectName(QStringLiteral("sideTitle"));
    m_size->setObjectName(QStringLiteral("sideSize"));
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    // Long titles are cut off rather than pushing the other fabric away.
    for (QLabel* label : {m_title, m_size}) {
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        label->setTextFormat(Qt::PlainText);
    }
    auto* words = new QVBoxLayout;
    words->setSpacing(1);
    words->addWidget(m_title);
    words->addWidget(m_size);
    m_row->setContentsMargins(12, 5, 6, 5);
    m_row->setSpacing(2);
    m_row->addLayout(words, 1);
    takePalette();
}

void SideHeading::setTitle(const QString& title) {
    m_title->setText(title);
    m_title->setToolTip(title);
}

void SideHeading::setSize(const QString& size) {
    m_size->setText(size);
    m_size->setToolTip(size.trimmed());
}

QString SideHeading::title() const {
    return m_title->text();
}

QString SideHeading::sizeText() const {
    return m_size->text();
}

void SideHeading::addButton(QWidget* button) {
    m_row->addWidget(button);
}

void SideHeading::takePalette() {
    QPalette faint = palette();
    faint.setColor(QPalette::WindowText, accentsOf(palette()).faintText);
    m_size->setPalette(faint);
}

void SideHeading::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        takePalette();
    }
    QWidget::changeEvent(event);
}

void SideHeading::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.setPen(accentsOf(palette()).line);
    painter.drawLine(rect().bottomLeft(), rect().bottomRight());
}

} // namespace knittsim::ui
