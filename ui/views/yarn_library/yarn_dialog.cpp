#include "ui/views/yarn_library/yarn_dialog.h"

#include "core/yarn/own_yarns.h"
#include "core/yarn/yarn_library.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/numbers.h"
#include "ui/views/yarn_library/yarn_details.h"

#include <QColorDialog>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <cmath>
#include <limits>

namespace knittsim::ui {

namespace {

/// Densities of fibres, g/cm3: textbook values, as in resources/yarns.
struct Fibre {
    const char* name;
    double density;
};
constexpr Fibre kFibres[] = {{QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "wool"), 1.31},
                             {QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "cashmere"), 1.31},
                             {QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "alpaca"), 1.31},
                             {QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "cotton"), 1.54},
                             {QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "linen"), 1.50},
                             {QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "silk"), 1.34},
                             {QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "viscose"), 1.52},
                             {QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "acrylic"), 1.17},
                             {QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "polyester"), 1.38},
                             {QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "polyamide"), 1.14}};
constexpr double kCorePacking = 0.9;
constexpr const char* kSurfaces[] = {QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "smooth"),
                                     QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "hairy"),
                                     QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "bulky"),
                                     QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "matte"),
                                     QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "glossy"),
                                     QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "lustrous"),
                                     QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "crimped"),
                                     QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "slubby"),
                                     QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "halo"),
                                     QT_TRANSLATE_NOOP("knittsim::ui::YarnDialog", "soft")};

double numberOf(const QString& text) {
    bool good = false;
    double value = text.trimmed().toDouble(&good);
    if (!good) {
        value = QLocale().toDouble(text.trimmed(), &good);
    }
    return good ? value : std::numeric_limits<double>::quiet_NaN();
}

/// Of the first known fibre that the text names; wool's where it names none.
double densityOf(const QString& fibre) {
    for (const Fibre& known : kFibres) {
        if (fibre.contains(QLatin1String(known.name), Qt::CaseInsensitive) ||
            fibre.contains(YarnDialog::tr(known.name), Qt::CaseInsensitive)) {
            return known.density;
        }
    }
    return kFibres[0].density;
}

/// As numberOf() reads it, with the decimal point of the user's language.
QString text(double value, char format = 'g', int digits = 5) {
    return withLocalPoint(QString::number(value, format, digits));
}

} // namespace

YarnDialog::YarnDialog(const yarn::Yarn& yarn, QWidget* parent)
    : QDialog(parent), m_original(yarn), m_colour(yarn.colour), m_fibre(new QComboBox(this)),
      m_system(new QComboBox(this)), m_counts(new QLabel(this)), m_packing(new QLineEdit(this)),
      m_surface(new QComboBox(this)), m_colourButton(new QPushButton(this)),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this)),
      m_sources(yarn.sources) {
    setObjectName(QStringLiteral("yarnDialog"));
    setWindowTitle(yarn.id.empty() ? tr("New yarn") : tr("Yarn %1").arg(QString::fromStdString(yarn.name)));
    auto* page = new QWidget(this);
    auto* form = new QFormLayout(page);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    addField(form, "name", tr("Name"), QString::fromStdString(yarn.name), tr("As it stands in the library"));
    m_fibre->setEditable(true);
    for (const Fibre& fibre : kFibres) {
        m_fibre->addItem(tr(fibre.name));
    }
    m_fibre->setCurrentText(QString::fromStdString(yarn.fibre));
    m_fibre->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_fibre->lineEdit()->setCursorPosition(0);
    m_counts->setWordWrap(true);
    m_fibre->setToolTip(tr("What it is made of; the density for the diameters follows from it"));
    addRow(form, "fibre", tr("Fibre"), m_fibre, m_fibre->lineEdit());
    QWidget* count = makeCount();
    addRow(form, "count.tex", tr("Count"), count, m_fields["count.tex"].edit);
    form->addRow(QString(), m_counts);
    QWidget* diameters = makeDiameters();
    addRow(form, "outer_diameter_mm", tr("Outer diameter, mm"), diameters,
           m_fields["outer_diameter_mm"].edit);
    addField(form, "core_diameter_mm", tr("Core diameter, mm"), text(yarn.coreDiameterMm),
             tr("Of the fibres pressed together"));
    addField(form, "axial_stiffness_n", tr("EA, stretching, N"), text(yarn.axialStiffnessMilliNewton / 1000),
             tr("Force that would double the length"));
    addField(form, "bending_stiffness_n_m2", tr("EI, bending, mN\u00b7mm\u00b2"), text(yarn.bendingStiffness),
             tr("How the yarn resists a bend"));
    addField(form, "friction", tr("Friction"), text(yarn.friction), tr("Yarn on yarn, 0 to 2"));
    for (const char* kind : kSurfaces) {
        m_surface->addItem(tr(kind), QString::fromLatin1(kind));
    }
    m_surface->setCurrentIndex(m_surface->findData(QString::fromStdString(yarn.surface.kind)));
    m_surface->setToolTip(tr("How the surface looks"));
    form->addRow(tr("Surface"), m_surface);
    addField(form, "surface.hairiness", tr("Hairiness"), text(yarn.surface.hairiness),
             tr("0 none, 1 brushed mohair"));
    addField(form, "surface.plies", tr("Plies"), QString::number(yarn.surface.plies),
             tr("Yarns twisted into one"));
    addField(form, "surface.twist_per_metre", tr("Twist per metre"), text(yarn.surface.twistPerMetre),
             tr("Turns of the plies; S is positive, Z negative"));
    m_colourButton->setObjectName(QStringLiteral("yarnColour"));
    m_colourButton->setToolTip(tr("The colour that it has in the library"));
    form->addRow(tr("Colour"), m_colourButton);
    connect(m_colourButton, &QPushButton::clicked, this, &YarnDialog::chooseColour);

    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(page);
    auto* rows = new QVBoxLayout(this);
    rows->addWidget(scroll, 1);
    rows->addWidget(m_buttons);
    resize(580, 560);
    m_fields["name"].edit->setFocus();
    m_fields["name"].edit->selectAll();
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    check();
}

void YarnDialog::addRow(QFormLayout* form, const QString& key, const QString& name, QWidget* editor,
                        QLineEdit* edit) {
    auto* reason = new QLabel(this);
    reason->setObjectName(key + QStringLiteral(".reason"));
    reason->setWordWrap(true);
    reason->hide();
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, accentsOf(colours).error);
    reason->setPalette(colours);
    edit->setObjectName(key);
    edit->setAccessibleName(name);
    m_fields[key] = {edit, reason};
    form->addRow(name, editor);
    form->addRow(QString(), reason);
    connect(edit, &QLineEdit::textChanged, this, &YarnDialog::check);
}

QLineEdit* YarnDialog::addField(QFormLayout* form, const QString& key, const QString& name,
                                const QString& text, const QString& help) {
    auto* edit = new QLineEdit(text, this);
    edit->setToolTip(help);
    addRow(form, key, name, edit, edit);
    return edit;
}

QWidget* YarnDialog::makeCount() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    auto* count = new QLineEdit(text(m_original.nm()), box);
    count->setToolTip(tr("How fine it is, in the unit beside"));
    m_fields["count.tex"].edit = count;
    m_system->setObjectName(QStringLiteral("countSystem"));
    m_system->setToolTip(tr("Another unit converts the number"));
    for (const yarn::CountSystem system : yarn::kCountSystems) {
        m_system->addItem(QString::fromLatin1(yarn::toString(system)));
    }
    m_system->setCurrentIndex(static_cast<int>(yarn::CountSystem::Nm));
    m_system->setProperty("before", m_system->currentIndex());
    connect(m_system, &QComboBox::currentIndexChanged, this, &YarnDialog::convertCount);
    row->addWidget(count, 1);
    row->addWidget(m_system);
    return box;
}

QWidget* YarnDialog::makeDiameters() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    auto* outer = new QLineEdit(text(m_original.outerDiameterMm), box);
    outer->setToolTip(tr("Of the hull of the fibres"));
    m_fields["outer_diameter_mm"].edit = outer;
    m_packing->setText(QStringLiteral("0.5"));
    m_packing->setObjectName(QStringLiteral("packing"));
    m_packing->setMaximumWidth(50);
    m_packing->setToolTip(tr("Part of the section that is fibre: ring spun 0.6, worsted 0.45 to 0.5, woollen "
                             "and bulked 0.25 to 0.3, textured 0.35, brushed 0.06"));
    auto* compute = new QPushButton(tr("From the count"), box);
    compute->setObjectName(QStringLiteral("computeDiameters"));
    compute->setToolTip(tr("d = 0.03568 \u221a(tex / (\u03c1 \u03c6)) mm, \u03c1 of the fibre in g/cm\u00b3, "
                           "\u03c6 as beside; 0.9 for the core"));
    connect(compute, &QPushButton::clicked, this, &YarnDialog::computeDiameters);
    row->addWidget(outer, 1);
    row->addWidget(new QLabel(QStringLiteral("\u03c6"), box));
    row->addWidget(m_packing);
    row->addWidget(compute);
    return box;
}

double YarnDialog::number(const QString& key) const {
    return numberOf(m_fields.at(key).edit->text());
}

double YarnDialog::tex() const {
    return yarn::texOf(static_cast<yarn::CountSystem>(m_system->currentIndex()), number("count.tex"));
}

void YarnDialog::convertCount() {
    const auto before = static_cast<yarn::CountSystem>(m_system->property("before").toInt());
    const double tex = yarn::texOf(before, number("count.tex"));
    m_system->setProperty("before", m_system->currentIndex());
    if (tex > 0) {
        m_fields["count.tex"].edit->setText(
            text(yarn::countOf(static_cast<yarn::CountSystem>(m_system->currentIndex()), tex)));
    }
    check();
}

void YarnDialog::computeDiameters() {
    const double packing = numberOf(m_packing->text());
    if (!(tex() > 0) || !(packing > 0 && packing <= 1)) {
        m_packing->setFocus();
        return;
    }
    const double density = densityOf(m_fibre->currentText());
    const auto compute = [&](const char* key, double part) {
        m_fields[QString::fromLatin1(key)].edit->setText(
            text(yarn::diameterMm(tex(), density, part), 'f', 3));
        m_sources[key] = QStringLiteral("formula 0.03568 sqrt(tex / (rho phi)) mm, rho = %1 g/cm3, phi = %2")
                             .arg(density)
                             .arg(part)
                             .toStdString();
    };
    compute("outer_diameter_mm", packing);
    compute("core_diameter_mm", kCorePacking);
}

void YarnDialog::chooseColour() {
    const QColor chosen =
        QColorDialog::getColor(QColor(m_colour.r, m_colour.g, m_colour.b), this, tr("Colour of the yarn"));
    if (chosen.isValid()) {
        m_colour = {static_cast<std::uint8_t>(chosen.red()), static_cast<std::uint8_t>(chosen.green()),
                    static_cast<std::uint8_t>(chosen.blue())};
        check();
    }
}

yarn::Yarn YarnDialog::yarn() const {
    const auto system = static_cast<yarn::CountSystem>(m_system->currentIndex());
    yarn::Yarn yarn = m_original;
    yarn.name = m_fields.at("name").edit->text().trimmed().toStdString();
    yarn.fibre = m_fibre->currentText().trimmed().toStdString();
    const double density = tex();
    if (std::abs(density - m_original.tex) > 1e-3 * m_original.tex) {
        yarn.tex = density;
        yarn.count = density > 0 ? yarn::countText(system, density) : std::string();
    }
    yarn.outerDiameterMm = number("outer_diameter_mm");
    yarn.coreDiameterMm = number("core_diameter_mm");
    yarn.axialStiffnessMilliNewton = 1000 * number("axial_stiffness_n");
    yarn.bendingStiffness = number("bending_stiffness_n_m2");
    yarn.friction = number("friction");
    yarn.colour = m_colour;
    yarn.surface.kind = m_surface->currentData().toString().toStdString();
    yarn.surface.hairiness = number("surface.hairiness");
    const double plies = number("surface.plies");
    yarn.surface.plies =
        plies >= 1 && plies <= 100 && std::floor(plies) == plies ? static_cast<int>(plies) : 0;
    yarn.surface.twistPerMetre = number("surface.twist_per_metre");
    if (yarn.id.empty()) {
        yarn.id = yarn::idOf(yarn.name);
    }
    // A number that was changed by hand has no other source any more.
    yarn.sources = m_sources;
    const auto byHand = [&](const char* key, bool changed) {
        const auto before = m_original.sources.find(key);
        const auto now = m_sources.find(key);
        const bool computed =
            now != m_sources.end() && (before == m_original.sources.end() || before->second != now->second);
        if (changed && !computed) {
            yarn.sources[key] = "entered by hand";
        }
    };
    byHand("count", yarn.tex != m_original.tex);
    byHand("outer_diameter_mm", yarn.outerDiameterMm != m_original.outerDiameterMm);
    byHand("core_diameter_mm", yarn.coreDiameterMm != m_original.coreDiameterMm);
    byHand("axial_stiffness_n", yarn.axialStiffnessMilliNewton != m_original.axialStiffnessMilliNewton);
    byHand("bending_stiffness_n_m2", yarn.bendingStiffness != m_original.bendingStiffness);
    byHand("friction", yarn.friction != m_original.friction);
    return yarn;
}

void YarnDialog::check() {
    if (!m_fields.contains("surface.twist_per_metre")) {
        return; // still being built
    }
    m_colourButton->setText(QColor(m_colour.r, m_colour.g, m_colour.b).name());
    QPixmap swatch(16, 16);
    swatch.fill(QColor(m_colour.r, m_colour.g, m_colour.b));
    m_colourButton->setIcon(swatch);
    QStringList counts;
    for (const yarn::CountSystem system : yarn::kCountSystems) {
        if (tex() > 0) {
            counts << countAsShown(system, tex()).replace(u' ', u'\u00a0'); // stays on one line
        }
    }
    m_counts->setText(counts.isEmpty() ? QString()
                                       : QStringLiteral("= ") + counts.join(QStringLiteral(" = ")));
    const auto read = yarn::parseYarn(yarn::toJson(yarn()), "yarn");
    for (auto& [key, field] : m_fields) {
        QString reason;
        for (const Diagnostic& problem : read.diagnostics()) {
            if (!problem.arguments.empty() && problem.arguments[0] == key.toStdString()) {
                reason = tr("Expected: %1").arg(QString::fromStdString(problem.arguments.back()));
            }
        }
        field.reason->setText(reason);
        field.reason->setVisible(!reason.isEmpty());
    }
    m_buttons->button(QDialogButtonBox::Save)->setEnabled(bool(read));
}

} // namespace knittsim::ui
