#include "ui/dialogs/yarn_choice_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPixmap>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace knittsim::ui {

namespace {

QIcon swatch(yarn::Colour colour) {
    QPixmap pixels(14, 14);
    pixels.fill(QColor(colour.r, colour.g, colour.b));
    return QIcon(pixels);
}

} // namespace

YarnChoiceDialog::YarnChoiceDialog(const document::Document& document, QWidget* parent)
    : QDialog(parent), m_yarns(document.library().yarns()), m_carrier(new QComboBox(this)),
      m_yarn(new QComboBox(this)), m_facts(new QLabel(this)) {
    setObjectName(QStringLiteral("yarnChoiceDialog"));
    setWindowTitle(tr("Compare with another yarn"));
    m_carrier->setObjectName(QStringLiteral("yarnChoiceCarrier"));
    m_carrier->setToolTip(tr("Whose yarn is exchanged"));
    m_yarn->setObjectName(QStringLiteral("yarnChoiceYarn"));
    m_yarn->setToolTip(tr("The yarn of the fabric beside"));
    m_yarn->setMaxVisibleItems(16);
    const auto& carriers = document.carriers();
    if (carriers.size() > 1) {
        m_carrier->addItem(tr("All carriers, each in its colour"), -1);
    }
    for (std::size_t i = 0; i < carriers.size(); ++i) {
        m_carrier->addItem(swatch(carriers[i].yarn.colour),
                           tr("Carrier %1: %2")
                               .arg(QString::fromStdString(carriers[i].carrier),
                                    QString::fromStdString(carriers[i].yarn.name)),
                           static_cast<int>(i));
    }
    for (const yarn::Yarn& yarn : m_yarns) {
        m_yarn->addItem(swatch(yarn.colour), QString::fromStdString(yarn.name));
    }
    auto* buttons = new QDialogButtonBox(this);
    auto* compare = buttons->addButton(tr("&Compare"), QDialogButtonBox::AcceptRole);
    compare->setObjectName(QStringLiteral("yarnChoiceCompare"));
    compare->setToolTip(tr("Settles the same program in this yarn beside (Enter)"));
    compare->setDefault(true);
    buttons->addButton(QDialogButtonBox::Cancel);
    auto* form = new QFormLayout;
    form->addRow(tr("&Exchange:"), m_carrier);
    form->addRow(tr("&Yarn:"), m_yarn);
    form->addRow(QString(), m_facts);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(20, 18, 20, 14);
    rows->setSpacing(12);
    rows->addLayout(form);
    rows->addWidget(buttons);
    setMinimumWidth(440);
    connect(m_yarn, &QComboBox::currentIndexChanged, this, &YarnChoiceDialog::takeYarn);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        if (m_yarn->currentIndex() >= 0 && m_carrier->currentIndex() >= 0) {
            emit chosen(m_carrier->currentData().toInt(),
                        m_yarns[static_cast<std::size_t>(m_yarn->currentIndex())]);
        }
        accept();
    });
    takeYarn();
}

void YarnChoiceDialog::takeYarn() {
    if (m_yarn->currentIndex() < 0) {
        return;
    }
    const yarn::Yarn& yarn = m_yarns[static_cast<std::size_t>(m_yarn->currentIndex())];
    m_facts->setText(tr("%1, %2, %3 mm thick")
                         .arg(QString::fromStdString(yarn.count), QString::fromStdString(yarn.fibre),
                              QLocale().toString(yarn.outerDiameterMm, 'f', 2)));
}

} // namespace knittsim::ui
