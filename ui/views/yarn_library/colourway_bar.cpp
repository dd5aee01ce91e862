#include "ui/views/yarn_library/colourway_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>

namespace knittsim::ui {

using pattern::Chart;
using pattern::Colourways;

namespace {

/// Of a chart that has no colourways yet.
QString firstName() {
    return ColourwayBar::tr("Colourway %1").arg(1);
}

} // namespace

ColourwayBar::ColourwayBar(document::Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_choice(new QComboBox(this)) {
    setObjectName(QStringLiteral("colourways"));
    m_choice->setObjectName(QStringLiteral("colourwayChoice"));
    m_choice->setAccessibleName(tr("Colourway"));
    m_choice->setToolTip(tr("Sets of yarns for the carriers, saved with the chart"));
    m_choice->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* more = new QToolButton(this);
    more->setObjectName(QStringLiteral("colourwayMenu"));
    more->setText(QStringLiteral("\u2026"));
    more->setToolTip(tr("Add, rename and delete colourways"));
    more->setAccessibleName(more->toolTip());
    more->setPopupMode(QToolButton::InstantPopup);
    more->setMenu(new QMenu(more));
    buildMenu(more->menu());
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(m_choice, 1);
    row->addWidget(more);
    connect(m_choice, &QComboBox::activated, this, &ColourwayBar::use);
    connect(&m_document, &document::Document::chartChanged, this, &ColourwayBar::take);
    take();
}

void ColourwayBar::buildMenu(QMenu* menu) {
    menu->addAction(tr("&Duplicate this one\u2026"), this, [this] {
        if (const QString name = askName(tr("New colourway"), nextName()); !name.isEmpty()) {
            add(name);
        }
    });
    menu->addAction(tr("&Rename\u2026"), this, [this] {
        if (const QString name = askName(tr("Rename the colourway"), m_choice->currentText());
            !name.isEmpty()) {
            rename(name);
        }
    });
    QAction* remove = menu->addAction(tr("De&lete"), this, &ColourwayBar::removeUsed);
    connect(menu, &QMenu::aboutToShow, this, [this, remove] { remove->setEnabled(m_choice->count() > 1); });
}

QString ColourwayBar::askName(const QString& title, const QString& name) {
    return QInputDialog::getText(this, title, tr("Name:"), QLineEdit::Normal, name).trimmed();
}

QString ColourwayBar::nextName() const {
    for (int i = m_choice->count() + 1;; ++i) {
        const QString name = tr("Colourway %1").arg(i);
        if (m_choice->findText(name) < 0) {
            return name;
        }
    }
}

void ColourwayBar::take() {
    const auto project = m_document.project();
    setVisible(project != nullptr);
    if (!project) {
        return;
    }
    const QSignalBlocker quiet(m_choice);
    m_choice->clear();
    for (const pattern::Colourway& colourway : project->colourways.all) {
        m_choice->addItem(QString::fromStdString(colourway.name));
    }
    if (m_choice->count() == 0) {
        m_choice->addItem(firstName());
    }
    m_choice->setCurrentIndex(project->colourways.used);
}

void ColourwayBar::useNext() {
    if (m_choice->count() > 1 && m_document.project()) {
        use((m_choice->currentIndex() + 1) % m_choice->count());
    }
}

void ColourwayBar::use(int index) {
    m_document.editColourways(
        tr("colourway %1").arg(m_choice->itemText(index)),
        [index](Colourways& colourways, Chart& chart) { pattern::useColourway(colourways, chart, index); });
}

void ColourwayBar::add(const QString& name) {
    m_document.editColourways(tr("new colourway"), [&](Colourways& colourways, Chart& chart) {
        pattern::addColourway(colourways, chart, name.toStdString(), firstName().toStdString());
    });
}

void ColourwayBar::rename(const QString& name) {
    m_document.editColourways(tr("name of the colourway"), [&](Colourways& colourways, Chart& chart) {
        if (colourways.all.empty()) {
            colourways.all.push_back({{}, chart.yarns});
        }
        colourways.all[static_cast<std::size_t>(colourways.used)].name = name.toStdString();
    });
}

void ColourwayBar::removeUsed() {
    m_document.editColourways(tr("delete a colourway"), [](Colourways& colourways, Chart& chart) {
        pattern::removeColourway(colourways, chart, colourways.used);
    });
}

} // namespace knittsim::ui
