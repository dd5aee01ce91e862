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
#include <cmath>
#include <limits>

namespace knittsim::ui {

namespace {

QIcon swatch(yarn::Colour colour) {
    QPixmap pixels(14, 14);
    pixels.fill(QColor(colour.r, colour.g, colour.b));
    return QIcon(pixels);
}

/// What is most like `present` without being it: a comparison begins with a small step.
int nearestTo(const yarn::Yarn& present, const std::vector<yarn::Yarn>& yarns) {
    const auto farness = [&](const yarn::Yarn& yarn) {
        return yarn.id == present.id ? std::numeric_limits<double>::infinity()
                                     : std::abs(yarn.outerDiameterMm - present.outerDiameterMm);
    };
    return static_cast<int>(std::ranges::min_element(yarns, {}, farness) - yarns.begin());
}

QString thickness(const yarn::Yarn& yarn) {
    return QLocale().toString(yarn.outerDiameterMm, 'f', 2);
}

} // namespace

YarnChoiceDialog::YarnChoiceDialog(const document::Document& document, QWidget* parent)
    : QDialog(parent), m_document(document), m_yarns(document.library().yarns()),
      m_carrier(new QComboBox(this)), m_yarn(new QComboBox(this)), m_facts(new QLabel(this)) {
    m_facts->setMinimumHeight(2 * fontMetrics().lineSpacing()); // so that nothing moves when the words change
    m_facts->setAlignment(Qt::AlignTop);
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
    connect(m_carrier, &QComboBox::currentIndexChanged, this, &YarnChoiceDialog::takeYarn);
    if (!carriers.empty() && !m_yarns.empty()) {
        m_yarn->setCurrentIndex(nearestTo(carriers.front().yarn, m_yarns));
    }
    takeYarn();
}

void YarnChoiceDialog::takeYarn() {
    if (m_yarn->currentIndex() < 0) {
        return;
    }
    const yarn::Yarn& yarn = m_yarns[static_cast<std::size_t>(m_yarn->currentIndex())];
    QString facts =
        tr("%1, %2, %3 mm thick")
            .arg(QString::fromStdString(yarn.count), QString::fromStdString(yarn.fibre), thickness(yarn));
    const int carrier = m_carrier->currentData().toInt();
    const auto& carriers = m_document.carriers();
    if (carrier >= 0 && static_cast<std::size_t>(carrier) < carriers.size()) {
        const yarn::Yarn& present = carriers[static_cast<std::size_t>(carrier)].yarn;
        facts +=
            u'\n' +
            tr("instead of %1, %2 mm thick").arg(QString::fromStdString(present.name), thickness(present));
    }
    m_facts->setText(facts);
}

} // namespace knittsim::ui
