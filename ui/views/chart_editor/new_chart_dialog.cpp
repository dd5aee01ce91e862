#include "ui/views/chart_editor/new_chart_dialog.h"

#include "core/pattern/catalogue.h"
#include "core/pattern/chart_edit.h"
#include "ui/views/chart_editor/palettes.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace knittsim::ui {

namespace {

constexpr int kWales = 40;
constexpr int kCourses = 40;
constexpr int kMostNew = 1000;
constexpr int kMostYarns = 6; ///< the least that a machine here has carriers for

} // namespace

NewChartDialog::NewChartDialog(QString machine, QWidget* parent)
    : QDialog(parent), m_machine(std::move(machine)), m_wales(new QSpinBox(this)),
      m_courses(new QSpinBox(this)), m_yarns(new QSpinBox(this)), m_ground(new QComboBox(this)),
      m_beds(new QComboBox(this)) {
    setObjectName(QStringLiteral("newChart"));
    setWindowTitle(tr("New chart"));
    for (QSpinBox* box : {m_wales, m_courses}) {
        box->setRange(1, kMostNew);
    }
    m_wales->setObjectName(QStringLiteral("newWales"));
    m_courses->setObjectName(QStringLiteral("newCourses"));
    m_wales->setValue(kWales);
    m_courses->setValue(kCourses);
    m_wales->setSuffix(tr(" stitches across"));
    m_courses->setSuffix(tr(" rows up"));
    m_wales->setToolTip(tr("Needles across"));
    m_courses->setToolTip(tr("Courses up"));
    m_yarns->setObjectName(QStringLiteral("newYarns"));
    m_yarns->setRange(1, kMostYarns);
    m_yarns->setToolTip(tr("Colours to draw with; more can be added at any time"));
    m_ground->setObjectName(QStringLiteral("newGround"));
    m_ground->setToolTip(tr("The stitches that it begins with"));
    for (const pattern::Module& module : pattern::catalogue()) {
        if (module.group == pattern::ModuleGroup::Texture) {
            m_ground->addItem(QString::fromStdString(module.name), QString::fromStdString(module.id));
        }
    }
    m_beds->setObjectName(QStringLiteral("newBeds"));
    m_beds->addItem(tr("Single: knit, purl, colours, cables, lace"));
    m_beds->addItem(tr("Double: full ribs, tubes, jacquard with a back"));
    m_beds->setToolTip(tr("Double: front and rear needle of each wale knit side by side; Pattern > Work on "
                          "both beds changes it"));
    auto* form = new QFormLayout;
    form->addRow(tr("&Wales"), m_wales);
    form->addRow(tr("&Courses"), m_courses);
    form->addRow(tr("&Yarns"), m_yarns);
    form->addRow(tr("&Ground"), m_ground);
    form->addRow(tr("&Fabric"), m_beds);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Create"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* rows = new QVBoxLayout(this);
    rows->addLayout(form);
    rows->addWidget(buttons);
    m_wales->selectAll();
}

pattern::Project NewChartDialog::project() const {
    pattern::Project project{.chart = pattern::Chart(m_wales->value(), m_courses->value()),
                             .machine = m_machine.toStdString()};
    for (int i = 0; i < m_yarns->value(); ++i) {
        project.chart.yarns.push_back(
            {std::to_string(i + 1), freshColour(static_cast<std::size_t>(i)), "merino-2-30"});
    }
    const pattern::Module* ground = pattern::findModule(m_ground->currentData().toString().toStdString());
    pattern::tile(project.chart, {0, 0, project.chart.width, project.chart.height()}, ground->part,
                  pattern::PasteWhat::Stitches);
    if (m_beds->currentIndex() == 1) {
        pattern::useBeds(project.chart, pattern::BedUse::Double);
    }
    return project;
}

} // namespace knittsim::ui
