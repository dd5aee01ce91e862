#include "core/fabric/machine_shape.h"
#include "ui/render/scene_chunks.h"
#include "ui/views/fabric_view/fabric_view_implementation.h"

namespace knittsim::ui {

std::optional<Vec3f> FabricView::Implementation::placeOfLoop(int loop) const {
    if (!fabric || loop < 0 || static_cast<std::size_t>(loop) >= fabric->loops.size()) {
        return std::nullopt;
    }
    const fabric::Loop& l = fabric->loops[static_cast<std::size_t>(loop)];
    if (l.headLeft < 0 || l.headRight < 0 || places.empty()) {
        return std::nullopt;
    }
    const auto place = [this](fabric::PointIndex point) {
        const auto i = 3 * static_cast<std::size_t>(fabric->points[static_cast<std::size_t>(point)].entry);
        return Vec3f(places[i], places[i + 1], places[i + 2]);
    };
    return Vec3f(0.5F * (place(l.headLeft) + place(l.headRight)));
}

/// Of the fabric that is wanted; empty: where the machine leaves it.
void FabricView::Implementation::takePlaces(std::span<const float> positions) {
    places.assign(positions.begin(), positions.end());
    if (places.empty() && fabric) {
        places = fabric::machinePlaces(*fabric);
    }
    annotate();
}

/// Puts the annotations where the fabric is now.
void FabricView::Implementation::annotate() {
    measured = false;
    annotations.problems.clear();
    if (fabric && !fabric->points.empty()) {
        for (const LoopProblem& problem : problems) {
            if (const auto place = placeOfLoop(problem.loop)) {
                annotations.problems.push_back({*place, problem.severity});
            }
        }
    }
    placeMarks();
}

/// When it is painted or asked for: shapes may follow each other faster.
void FabricView::Implementation::measure() {
    if (measured) {
        return;
    }
    measured = true;
    annotations.size.reset();
    annotations.lattice.reset();
    if (fabric && !fabric->points.empty()) {
        annotations.size = geometry::measure(*fabric, places);
        if (annotations.guides) {
            annotations.lattice = geometry::stitchLattice(*fabric, places);
        }
    }
}

/// All of the scene, or the yarn or course that is to be seen alone.
void FabricView::Implementation::showParts() {
    content.scene = wholeScene;
    annotations.alone.clear();
    keep.clear();
    if (alone == Alone::Nothing || !wholeScene || !shownFabric) {
        return;
    }
    keep.resize(shownFabric->points.size(), false);
    if (alone == Alone::Yarn && static_cast<std::size_t>(aloneIndex) < shownFabric->yarns.size()) {
        const fabric::Yarn& yarn = shownFabric->yarns[static_cast<std::size_t>(aloneIndex)];
        std::fill_n(keep.begin() + yarn.first, yarn.count, true);
        annotations.alone = tr("only yarn %1").arg(aloneIndex + 1);
    } else if (alone == Alone::Course) {
        for (std::size_t p = 0; p < keep.size(); ++p) {
            const machine::LoopIndex loop = shownFabric->points[p].loop;
            keep[p] = loop >= 0 && shownFabric->loops[static_cast<std::size_t>(loop)].course == aloneIndex;
        }
        annotations.alone = tr("only course %1").arg(aloneIndex + 1);
    }
    content.scene = render::isolated(*wholeScene, *shownFabric, keep);
}

/// On the yarn there, else in the plane through the middle of the picture that is parallel to it.
std::optional<Vec3f> FabricView::Implementation::tapePlaceAt(QPointF where) const {
    if (const auto pick = pickAt(where)) {
        return pick->place;
    }
    const render::Camera& camera = content.camera;
    return geometry::meetPlane(camera.rayAt(static_cast<float>(where.x()), static_cast<float>(where.y())),
                               annotations.tape.size() == 1 ? annotations.tape.front()
                                                            : camera.state().target,
                               camera.towardsViewer());
}

void FabricView::Implementation::tapeClick(QPointF where) {
    const auto place = tapePlaceAt(where);
    if (!place) {
        return;
    }
    if (annotations.tape.size() > 1) {
        annotations.tape.clear();
    }
    annotations.tape.push_back(*place);
    annotations.tapeEnd.reset();
    overlay->update();
    if (annotations.tape.size() == 2) {
        emit view.measured((annotations.tape[1] - annotations.tape[0]).norm());
    }
}

void FabricView::setNotice(const QString& text) {
    if (text != m->annotations.notice) {
        m->annotations.notice = text;
        m->overlay->update();
    }
}

void FabricView::setDimensions(bool on) {
    m->annotations.dimensions = on;
    m->overlay->update();
    emit displayChanged();
}
bool FabricView::hasDimensions() const {
    return m->annotations.dimensions;
}

void FabricView::setGuides(bool on) {
    m->annotations.guides = on;
    m->annotate();
    m->headChanged();
    emit displayChanged();
}
bool FabricView::hasGuides() const {
    return m->annotations.guides;
}

void FabricView::setProblemMarks(bool on) {
    m->annotations.marks = on;
    m->headChanged();
    emit displayChanged();
}
bool FabricView::hasProblemMarks() const {
    return m->annotations.marks;
}

int FabricView::problemMarkCount() const {
    return static_cast<int>(m->annotations.problems.size());
}

void FabricView::setNeedles(std::vector<fabric::NeedleHook> needles) {
    if (!needles.empty() || !m->annotations.needles.empty()) {
        m->annotations.needles = std::move(needles);
        m->overlay->update();
    }
}

void FabricView::setProblems(std::vector<LoopProblem> problems) {
    m->problems = std::move(problems);
    m->annotate();
}

void FabricView::setTaping(bool on) {
    m->annotations.taping = on;
    m->annotations.tape.clear();
    m->annotations.tapeEnd.reset();
    setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
    m->overlay->update();
}
bool FabricView::isTaping() const {
    return m->annotations.taping;
}

void FabricView::setSection(bool on) {
    m->content.section.reset();
    if (on && m->content.scene) {
        const auto place = m->placeOfLoop(m->content.selected);
        m->content.section = render::Section{place.value_or(m->content.scene->bounds.centre()),
                                             m->content.camera.towardsViewer()};
    }
    m->overlay->update();
    m->canvas->refresh();
}
const std::optional<render::Section>& FabricView::section() const {
    return m->content.section;
}

void FabricView::Implementation::moveSection(double notches) {
    constexpr float kShare = 0.01F; ///< of the fabric, for a notch
    render::Section& section = *content.section;
    section.point +=
        static_cast<float>(notches) * kShare * content.scene->bounds.size().norm() * section.normal;
    overlay->update();
    canvas->refresh();
}

bool FabricView::showAlone(Alone what) {
    const int loop = m->content.selected >= 0 ? m->content.selected : m->content.hovered;
    const bool known =
        m->shownFabric && loop >= 0 && static_cast<std::size_t>(loop) < m->shownFabric->loops.size();
    if (what != Alone::Nothing && !known) {
        return false;
    }
    m->alone = what;
    if (what == Alone::Yarn) {
        m->aloneIndex = m->shownFabric->made.loops[static_cast<std::size_t>(loop)].yarn;
    } else if (what == Alone::Course) {
        m->aloneIndex = m->shownFabric->loops[static_cast<std::size_t>(loop)].course;
    }
    m->showParts();
    m->changed();
    m->overlay->update();
    return true;
}
FabricView::Alone FabricView::alone() const {
    return m->alone;
}

void FabricView::setDescriber(std::function<QString(int)> describer) {
    m->describer = std::move(describer);
}

QStringList FabricView::words() const {
    QStringList words{m->overlay->sideText()};
    for (const Overlay::Word& word : m->overlay->words()) {
        words << word.text;
    }
    return words;
}

QString FabricView::shownPart() const {
    return m->annotations.alone;
}

std::vector<bool> FabricView::shownPoints() const {
    return m->keep;
}

std::optional<geometry::Measurement> FabricView::measurement() const {
    m->measure();
    return m->annotations.size;
}

} // namespace knittsim::ui
