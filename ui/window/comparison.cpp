#include "ui/window/comparison.h"

#include "ui/document/message_text.h"
#include "ui/views/simulation_panel/activity_text.h"
#include "ui/views/style/icons.h"
#include "ui/window/carrier_looks.h"
#include "ui/window/side_heading.h"

#include <QFileInfo>
#include <QLocale>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knittsim::ui {

using document::Document;

namespace {

/// "+4 %" of a length compared with another one; empty where they are equal.
QString differenceText(float length, float compared) {
    const long percent = compared > 0 ? std::lround(100 * (length / compared - 1)) : 0;
    return percent == 0 ? QString()
                        : QStringLiteral(" (%1%2 %)")
                              .arg(percent > 0 ? QStringLiteral("+") : QStringLiteral("\u2212"))
                              .arg(std::abs(percent));
}

QString sizeText(const FabricView& view, const FabricView* compared) {
    const geometry::Bounds box = view.bounds();
    const auto measured = view.measurement();
    if (box.empty() || !measured) {
        return QStringLiteral("\n"); // both headings are always equally high, for the sake of the scale
    }
    const QLocale locale;
    const geometry::Bounds other = compared ? compared->bounds() : geometry::Bounds();
    const bool known = !other.empty();
    QString text = Comparison::tr("%1%2 \u00d7 %3%4 mm")
                       .arg(locale.toString(box.size().x(), 'f', 1),
                            known ? differenceText(box.size().x(), other.size().x()) : QString(),
                            locale.toString(box.size().y(), 'f', 1),
                            known ? differenceText(box.size().y(), other.size().y()) : QString());
    if (measured->waleSpacingMm > 0 && measured->courseSpacingMm > 0) {
        text += Comparison::tr("\n%1 wales, %2 courses in 10 cm")
                    .arg(locale.toString(100 / measured->waleSpacingMm, 'f', 1),
                         locale.toString(100 / measured->courseSpacingMm, 'f', 1));
    }
    return text;
}

} // namespace

Comparison::Comparison(Document& document, FabricView& fabric, QWidget* parent)
    : QWidget(parent), m_document(document), m_fabric(fabric), m_splitter(new QSplitter(this)),
      m_heading(new SideHeading(this)) {
    setObjectName(QStringLiteral("comparison"));
    m_heading->setObjectName(QStringLiteral("thisHeading"));
    m_heading->hide();
    m_splitter->setChildrenCollapsible(false);
    m_splitter->addWidget(column(m_heading, &m_fabric));
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(m_splitter);
    connect(&m_fabric, &FabricView::cameraMoved, this, [this] {
        if (m_other) {
            follow(m_fabric, *m_other);
        }
    });
    connect(&m_fabric, &FabricView::sceneChanged, this, &Comparison::makeRoom);
    connect(&m_fabric, &FabricView::displayChanged, this, [this] {
        if (m_other) {
            m_other->takeDisplay(m_fabric);
        }
    });
    connect(&m_document, &Document::activityChanged, this, &Comparison::takeHeadings);
    connect(&m_document, &Document::yarnRunChanged, this, &Comparison::takeHeadings);
}

Comparison::~Comparison() {
    disconnect(&m_fabric, nullptr, this, nullptr);
    removeOther();
}

QWidget* Comparison::column(SideHeading* heading, FabricView* view) {
    auto* column = new QWidget;
    auto* rows = new QVBoxLayout(column);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(heading);
    rows->addWidget(view, 1);
    return column;
}

QToolButton* Comparison::button(const QString& name, const QString& iconName, const QString& tip) {
    auto* made = new QToolButton(m_otherHeading);
    made->setObjectName(name);
    made->setIcon(icon(iconName));
    made->setAutoRaise(true);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    m_otherHeading->addButton(made);
    return made;
}

void Comparison::openOther(const QString& title) {
    close();
    m_otherTitle = title;
    m_otherHeading = new SideHeading;
    m_otherHeading->setObjectName(QStringLiteral("otherHeading"));
    m_settle = button(QStringLiteral("otherSettle"), QStringLiteral("style-yarn"),
                      tr("Settles this side as yarn, or stops it"));
    m_settle->hide();
    m_link = button(QStringLiteral("otherLink"), QStringLiteral("link"), tr("Links the cameras (J)"));
    m_link->setCheckable(true);
    m_link->setChecked(m_linked);
    auto* shut =
        button(QStringLiteral("otherClose"), QStringLiteral("close"), tr("Closes the comparison (Escape)"));
    m_other = new FabricView;
    m_other->setObjectName(QStringLiteral("otherFabric"));
    m_other->setAccessibleName(tr("The fabric that is compared"));
    m_other->takeDisplay(m_fabric);
    m_splitter->addWidget(column(m_otherHeading, m_other));
    m_splitter->setSizes({1 << 16, 1 << 16});
    connect(m_link, &QToolButton::toggled, this, &Comparison::setLinked);
    connect(shut, &QToolButton::clicked, this, &Comparison::close, Qt::QueuedConnection);
    connect(m_other, &FabricView::cameraMoved, this, [this] { follow(*m_other, m_fabric); });
    connect(m_other, &FabricView::sceneChanged, this, &Comparison::makeRoom);
    m_heading->show();
    takeHeadings();
    emit changed();
}

void Comparison::close() {
    if (!m_other) {
        return;
    }
    removeOther();
    m_heading->hide();
    m_fabric.setFitRoom(Vec3f::Zero());
    m_fabric.setFocus();
    emit changed();
}

/// This side hears of its new width while the other one goes.
void Comparison::removeOther() {
    m_otherDocument.reset();
    m_shownFabric.reset();
    m_otherHeading = nullptr;
    m_link = m_settle = nullptr;
    if (QWidget* view = std::exchange(m_other, nullptr)) {
        delete view->parentWidget();
    }
}

void Comparison::keepState() {
    const auto fabric = m_document.shownFabric();
    if (!fabric) {
        return;
    }
    openOther(tr("Kept: %1, %2").arg(m_document.title(), activityWord(m_document)));
    m_other->setFabric(fabric, looksOf(m_document.carriers()));
    if (const auto frame = m_document.shownFrame()) {
        m_other->setFrame(frame);
    }
    if (m_document.showsYarn()) {
        m_other->setYarn(m_document.yarnRun().shape()->picture);
    }
}

Document& Comparison::makeDocument() {
    m_otherDocument = std::make_unique<Document>();
    Document& other = *m_otherDocument;
    m_settle->show();
    connect(&other, &Document::openFailed, this, [this, &other] {
        const auto file = other.failedFile();
        QString text = tr("%1 could not be opened.").arg(file->request.title);
        if (!file->diagnostics.empty()) {
            text += u' ' + document::causeText(file->diagnostics.front());
        }
        // Not from inside the document that goes with it.
        QMetaObject::invokeMethod(this, &Comparison::close, Qt::QueuedConnection);
        emit failed(text);
    });
    connect(&other, &Document::fabricShown, this, &Comparison::takeOther);
    connect(&other, &Document::frameShown, this, &Comparison::takeOther);
    connect(&other, &Document::yarnRunChanged, this, &Comparison::takeOther);
    connect(&other, &Document::yarnsChanged, this,
            [this, &other] { m_other->setLooks(looksOf(other.carriers())); });
    connect(&other, &Document::activityChanged, this, &Comparison::takeHeadings);
    connect(m_settle, &QToolButton::clicked, &other, &Document::settleYarn);
    return other;
}

void Comparison::openFile(const QString& path) {
    openOther(QFileInfo(path).fileName());
    Document& other = makeDocument();
    connect(&other, &Document::opened, this, [this] { takeOpened(-1, std::nullopt); });
    other.open(path);
}

void Comparison::openYarn(int carrier, const yarn::Yarn& yarn) {
    const auto file = m_document.file();
    if (!file) {
        return;
    }
    openOther(tr("%1 in %2").arg(m_document.title(), QString::fromStdString(yarn.name)));
    Document& other = makeDocument();
    connect(&other, &Document::opened, this, [this, carrier, yarn] { takeOpened(carrier, yarn); });
    other.setMachine(m_document.chosenMachine());
    if (const auto project = m_document.project()) {
        other.openProject(m_document.title(), project);
    } else if (file->request.path.isEmpty()) {
        other.openText(file->request.title, file->request.text);
    } else {
        other.open(file->request.path);
    }
}

/// Of the other document. With a yarn the carriers are those of this side but for that one.
void Comparison::takeOpened(int carrier, const std::optional<yarn::Yarn>& yarn) {
    Document& other = *m_otherDocument;
    if (yarn) {
        const auto count = std::min(m_document.carriers().size(), other.carriers().size());
        for (std::size_t i = 0; i < count; ++i) {
            const bool another = carrier < 0 || static_cast<std::size_t>(carrier) == i;
            yarn::Yarn next = another ? *yarn : m_document.carriers()[i].yarn;
            if (carrier < 0) {
                next.colour = m_document.carriers()[i].yarn.colour; // they would not be told apart
            }
            other.assignYarn(static_cast<int>(i), next);
        }
        other.undoStack()->setClean(); // nobody is to be asked to save it
    }
    if (m_document.showsYarn()) {
        other.settleYarn();
    } else {
        other.start();
    }
}

void Comparison::takeOther() {
    const Document& other = *m_otherDocument;
    const auto fabric = other.shownFabric();
    if (fabric && fabric != m_shownFabric) {
        m_other->setFabric(fabric, looksOf(other.carriers()));
    }
    m_shownFabric = fabric;
    if (const auto frame = other.shownFrame()) {
        m_other->setFrame(frame);
    }
    m_other->setYarn(other.showsYarn() ? other.yarnRun().shape()->picture : nullptr);
    takeHeadings();
}

void Comparison::setLinked(bool on) {
    if (on == m_linked) {
        return;
    }
    m_linked = on;
    if (m_link) {
        m_link->setChecked(on);
    }
    if (on && m_other) {
        follow(m_fabric, *m_other);
    }
    emit changed();
}

void Comparison::fit() {
    m_fabric.fit();
    if (m_other && !m_linked) {
        m_other->fit();
    }
}

/// Same direction and scale; what lies in the middle of one fabric lies in the middle of the other.
void Comparison::follow(FabricView& from, FabricView& to) {
    const geometry::Bounds here = from.bounds();
    const geometry::Bounds there = to.bounds();
    if (!m_linked || m_following || here.empty() || there.empty()) {
        return;
    }
    m_following = true;
    render::CameraState state = from.cameraState();
    state.target += there.centre() - here.centre();
    to.setCameraState(state);
    m_following = false;
}

/// Another shape has come: the larger one decides the scale.
void Comparison::makeRoom() {
    if (!m_other) {
        return;
    }
    const auto sizeOf = [](const FabricView& view) -> Vec3f {
        const geometry::Bounds box = view.bounds();
        return box.empty() ? Vec3f(Vec3f::Zero()) : box.size();
    };
    m_other->setFitRoom(sizeOf(m_fabric));
    m_fabric.setFitRoom(sizeOf(*m_other));
    follow(m_fabric, *m_other);
    takeHeadings();
}

void Comparison::takeHeadings() {
    if (!m_other) {
        return;
    }
    m_heading->setTitle(QStringLiteral("%1, %2").arg(m_document.title(), activityWord(m_document)));
    m_heading->setSize(sizeText(m_fabric, nullptr));
    m_otherHeading->setTitle(m_otherDocument
                                 ? QStringLiteral("%1, %2").arg(m_otherTitle, activityWord(*m_otherDocument))
                                 : m_otherTitle);
    m_otherHeading->setSize(sizeText(*m_other, &m_fabric));
}

QString Comparison::otherTitle() const {
    return m_other ? m_otherHeading->title() : QString();
}

QString Comparison::sizes(bool other) const {
    return !m_other ? QString() : other ? m_otherHeading->sizeText() : m_heading->sizeText();
}

} // namespace knittsim::ui
