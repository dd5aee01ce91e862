#include "ui/window/photograph_card.h"

#include "ui/views/style/appearance.h"
#include "ui/views/style/icons.h"

#include <QCheckBox>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

namespace knittsim::ui {

namespace {

constexpr int kMargin = 12;
constexpr int kWidth = 280;
constexpr int kAboveScale = 64; ///< the scale bar stays free

} // namespace

PhotographCard::PhotographCard(FabricView& fabric)
    : QFrame(&fabric), m_fabric(fabric), m_title(new QLabel(this)),
      m_opacity(
          slider(QStringLiteral("photographOpacity"), tr("How strongly the photograph covers the fabric"))),
      m_wipe(slider(QStringLiteral("photographWipe"), tr("Wipes the photograph away from the left"))),
      m_beside(new QCheckBox(tr("&Beside the fabric"), this)) {
    setObjectName(QStringLiteral("photographCard"));
    setAccessibleName(tr("Photograph"));
    setAttribute(Qt::WA_NoMousePropagation);
    setCursor(Qt::ArrowCursor);
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_beside->setObjectName(QStringLiteral("photographBeside"));
    m_beside->setToolTip(tr("On the right of the fabric in the same scale, instead of over it"));
    const auto button = [this](const QString& name, const QString& text, const QString& tip) {
        auto* made = new QPushButton(text, this);
        made->setObjectName(name);
        made->setToolTip(tip);
        return made;
    };
    auto* align = button(QStringLiteral("photographAlign"), tr("&Align\u2026"),
                         tr("Two points of the photograph on two of the fabric (Shift+W)"));
    auto* other = button(QStringLiteral("photographOpen"), tr("&Other\u2026"),
                         tr("Opens another photograph (Ctrl+Alt+P)"));
    auto* remove = button(QStringLiteral("photographRemove"), tr("&Remove"), tr("Forgets the photograph"));
    auto* hide = new QToolButton(this);
    hide->setObjectName(QStringLiteral("photographHide"));
    hide->setAutoRaise(true);
    hide->setIcon(icon(QStringLiteral("close")));
    hide->setToolTip(tr("Hides the photograph; W shows it again"));
    hide->setAccessibleName(tr("Hide the photograph"));
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(hide);
    auto* form = new QFormLayout;
    form->addRow(tr("O&pacity"), m_opacity);
    form->addRow(tr("&Wipe"), m_wipe);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* each : {align, other, remove}) {
        buttons->addWidget(each);
    }
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(12, 8, 8, 10);
    rows->setSpacing(6);
    rows->addLayout(head);
    rows->addLayout(form);
    rows->addWidget(m_beside);
    rows->addLayout(buttons);
    QFrame::hide();
    fabric.installEventFilter(this);
    for (QSlider* each : {m_opacity, m_wipe}) {
        connect(each, &QSlider::valueChanged, this, &PhotographCard::apply);
    }
    connect(m_beside, &QCheckBox::toggled, this, &PhotographCard::apply);
    connect(align, &QPushButton::clicked, this, &PhotographCard::alignWanted);
    connect(other, &QPushButton::clicked, this, &PhotographCard::openWanted);
    connect(remove, &QPushButton::clicked, this, [this] { m_fabric.setPhotograph({}); });
    connect(hide, &QToolButton::clicked, this, [this] {
        Photograph photograph = m_fabric.photograph();
        photograph.shown = false;
        m_fabric.setPhotograph(std::move(photograph));
    });
    connect(&fabric, &FabricView::photographChanged, this, &PhotographCard::take);
}

QSlider* PhotographCard::slider(const QString& name, const QString& tip) {
    auto* made = new QSlider(Qt::Horizontal, this);
    made->setObjectName(name);
    made->setRange(0, 100);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    return made;
}

void PhotographCard::take() {
    const Photograph& photograph = m_fabric.photograph();
    setVisible(photograph.visible());
    const QSignalBlocker quiet[] = {QSignalBlocker(m_opacity), QSignalBlocker(m_wipe),
                                    QSignalBlocker(m_beside)};
    m_title->setText(QFileInfo(photograph.path).fileName());
    m_title->setToolTip(photograph.path);
    m_opacity->setValue(qRound(100 * photograph.opacity));
    m_wipe->setValue(qRound(100 * photograph.wipe));
    m_beside->setChecked(photograph.beside);
    m_opacity->setEnabled(!photograph.beside);
    m_wipe->setEnabled(!photograph.beside);
    place();
    raise();
}

void PhotographCard::apply() {
    Photograph photograph = m_fabric.photograph();
    photograph.opacity = m_opacity->value() / 100.0;
    photograph.wipe = m_wipe->value() / 100.0;
    photograph.beside = m_beside->isChecked();
    m_fabric.setPhotograph(std::move(photograph));
}

void PhotographCard::place() {
    resize(std::min(kWidth, m_fabric.width() - 2 * kMargin), sizeHint().height());
    move(m_fabric.width() - width() - kMargin, m_fabric.height() - height() - kAboveScale);
}

bool PhotographCard::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parent() && event->type() == QEvent::Resize) {
        place();
    }
    return QFrame::eventFilter(watched, event);
}

void PhotographCard::paintEvent(QPaintEvent*) {
    paintCard(*this);
}

} // namespace knittsim::ui
