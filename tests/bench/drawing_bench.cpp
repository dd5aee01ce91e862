// Drawing: milliseconds for a frame of 900 stitches at 1280 x 800, as a ratio to clearing the same
// framebuffer in the same run, and the work on either side of the thread border for 10,000 stitches: curves
// (any thread) and upload.

#include "core/fabric/fabric_builder.h"
#include "core/pattern/swatch.h"
#include "tests/support/lattice.h"
#include "ui/render/egl_context.h"
#include "ui/render/fabric_renderer.h"
#include "ui/render/frame_target.h"

#include <benchmark/benchmark.h>

#include <chrono>

namespace {

using namespace knittsim;
using Clock = std::chrono::steady_clock;
using render::DrawStyle;

constexpr double kLoopMm = 5;

double milliseconds(Clock::duration time) {
    return std::chrono::duration<double, std::milli>(time).count();
}

struct Swatch {
    explicit Swatch(int side)
        : fabric(std::make_shared<fabric::Fabric>(fabric::buildFabric(
              machine::Timeline(pattern::makePlain(side, side), machine::genericProfile())))),
          positions(test::relaxedLattice(*fabric, kLoopMm)) {
        looks.resize(1);
        looks[0].diameterMm = kLoopMm / 9;
    }

    std::shared_ptr<const fabric::Fabric> fabric;
    std::vector<float> positions;
    std::vector<render::YarnLook> looks;
};

/// One context for all benchmarks; null where there is no OpenGL.
struct Graphics {
    std::unique_ptr<render::EglContext> context;
    std::unique_ptr<render::FabricRenderer> renderer;
    std::unique_ptr<render::FrameTarget> target;
};

Graphics* graphics(int width, int height) {
    static Graphics g;
    if (!g.context) {
        auto context = render::EglContext::create();
        if (!context) {
            return nullptr;
        }
        g.context = std::move(context.value());
        auto renderer = render::FabricRenderer::create();
        auto target = render::FrameTarget::create(width, height, 0); // as pictures in motion are drawn
        if (!renderer || !target) {
            return nullptr;
        }
        g.renderer = std::move(renderer.value());
        g.target = std::move(target.value());
    }
    return &g;
}

template<class Work> double timeOf(int repeats, const Work& work) {
    work();
    const auto start = Clock::now();
    for (int i = 0; i < repeats; ++i) {
        work();
    }
    return milliseconds(Clock::now() - start) / repeats;
}

void drawing(benchmark::State& state) {
    constexpr int kWidth = 1280;
    constexpr int kHeight = 800;
    Graphics* g = graphics(kWidth, kHeight);
    if (g == nullptr) {
        state.SkipWithError("no OpenGL without a window here");
        return;
    }
    const Swatch swatch(static_cast<int>(state.range(1)));
    render::FabricScene scene(swatch.fabric, swatch.looks, static_cast<DrawStyle>(state.range(0)));
    const auto frame = scene.prepare(swatch.positions);
    g->renderer->upload(frame);
    g->renderer->setLooks(swatch.looks);
    render::View view;
    view.width = kWidth;
    view.height = kHeight;
    if (state.range(2) != 0) {
        view.level = render::DetailLevel::Yarn;
    }
    view.camera.setViewport(kWidth, kHeight);
    view.camera.setScene(frame->bounds);
    view.camera.fit(frame->bounds);
    const auto draw = [&] {
        g->target->bind();
        g->renderer->draw(view);
        g->target->finish();
    };
    const auto clear = [&] {
        g->target->clear();
        g->target->finish();
    };
    const double clearing = timeOf(5, clear);
    double total = 0;
    draw();
    for (auto _ : state) {
        const auto start = Clock::now();
        draw();
        total += milliseconds(Clock::now() - start);
    }
    state.SetLabel(g->renderer->rendererName());
    state.counters["stitches"] = static_cast<double>(swatch.fabric->loops.size());
    state.counters["segments"] = static_cast<double>(frame->nodes.size());
    state.counters["ratio to clearing"] = total / static_cast<double>(state.iterations()) / clearing;
}
BENCHMARK(drawing)
    ->ArgNames({"style", "side", "full"})
    ->Args({static_cast<int>(DrawStyle::Yarn), 30, 0})
    ->Args({static_cast<int>(DrawStyle::Yarn), 30, 1})
    ->Args({static_cast<int>(DrawStyle::Strokes), 30, 0})
    ->Args({static_cast<int>(DrawStyle::Mesh), 30, 0})
    ->Args({static_cast<int>(DrawStyle::Yarn), 100, 0})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime() // of all threads: the software driver draws with several
    ->UseRealTime();

void curves(benchmark::State& state) {
    const Swatch swatch(static_cast<int>(state.range(0)));
    const std::vector<double> diameters{swatch.looks[0].diameterMm};
    geometry::YarnCurveBuilder builder(
        *swatch.fabric, diameters,
        {.samplesPerSegment = render::samplesFor(*swatch.fabric), .withSurface = true});
    std::vector<float> copy(swatch.positions.size());
    const double copying = timeOf(20, [&] {
        std::ranges::copy(swatch.positions, copy.begin());
        benchmark::DoNotOptimize(copy.data());
    });
    const auto start = Clock::now();
    for (auto _ : state) {
        benchmark::DoNotOptimize(builder.update(swatch.positions).nodes.data());
    }
    const double each = milliseconds(Clock::now() - start) / static_cast<double>(state.iterations());
    state.counters["nodes"] = static_cast<double>(builder.curves().nodes.size());
    state.counters["ns/node"] = each * 1e6 / static_cast<double>(builder.curves().nodes.size());
    state.counters["ratio to copying positions"] = each / copying;
}
BENCHMARK(curves)->Arg(30)->Arg(100)->Unit(benchmark::kMillisecond);

void prepare(benchmark::State& state) {
    const Swatch swatch(static_cast<int>(state.range(0)));
    render::FabricScene scene(swatch.fabric, swatch.looks, DrawStyle::Yarn);
    for (auto _ : state) {
        benchmark::DoNotOptimize(scene.prepare(swatch.positions)->nodes.data());
    }
    state.counters["stitches"] = static_cast<double>(swatch.fabric->loops.size());
}
BENCHMARK(prepare)->Arg(30)->Arg(100)->Unit(benchmark::kMillisecond);

void upload(benchmark::State& state) {
    Graphics* g = graphics(1280, 800);
    if (g == nullptr) {
        state.SkipWithError("no OpenGL without a window here");
        return;
    }
    const Swatch swatch(static_cast<int>(state.range(0)));
    render::FabricScene scene(swatch.fabric, swatch.looks, DrawStyle::Yarn);
    const auto first = scene.prepare(swatch.positions);
    const auto second = scene.prepare(swatch.positions);
    const std::vector<std::byte> source(first->nodes.size() * 24);
    std::vector<std::byte> copy(source.size());
    const double copying = timeOf(10, [&] {
        std::ranges::copy(source, copy.begin());
        benchmark::DoNotOptimize(copy.data());
    });
    bool odd = false;
    const auto start = Clock::now();
    for (auto _ : state) {
        g->renderer->upload(odd ? first : second);
        odd = !odd;
    }
    const double each = milliseconds(Clock::now() - start) / static_cast<double>(state.iterations());
    state.counters["bytes"] = static_cast<double>(source.size());
    state.counters["ratio to copying as much"] = each / copying;
}
BENCHMARK(upload)->Arg(30)->Arg(100)->Unit(benchmark::kMillisecond);

} // namespace
