// Edits a chart without end, saves it now and then, and is killed by kill_test.cpp at any moment.
//
//   kill_child FILE
//
// The number of the edit stands in the first course: bit i of it is set where wale i is purl. Each edit is
// told on standard output before it is done.

#include "ui/document/document.h"

#include <QCoreApplication>
#include <QTimer>

#include <cstdio>

using namespace knittsim;

namespace {

constexpr int kWales = 16;
constexpr int kEditMs = 40;
constexpr int kFirstSave = 20;
constexpr int kEditsBetweenSaves = 190; ///< copies are written in between

void write(pattern::Chart& chart, int number) {
    for (int wale = 0; wale < kWales; ++wale) {
        chart.at(wale, 0).stitch = (number >> wale & 1) != 0 ? pattern::Stitch::Purl : pattern::Stitch::Knit;
    }
}

} // namespace

int main(int count, char** words) {
    QCoreApplication application(count, words);
    document::Document document;
    auto project = std::make_shared<pattern::Project>();
    project->chart = pattern::Chart(kWales, 4);
    project->chart.yarns = {{"1", {}, "merino-2-30"}};
    QTimer timer;
    int number = 0;
    QObject::connect(&timer, &QTimer::timeout, &document, [&] {
        ++number;
        std::printf("%d\n", number);
        std::fflush(stdout);
        document.editChart("edit", [&](pattern::Chart& chart) { write(chart, number); });
        if (number % kEditsBetweenSaves == kFirstSave) {
            document.save(QString::fromLocal8Bit(words[1]));
        }
    });
    QObject::connect(&document, &document::Document::opened, &timer, [&] { timer.start(kEditMs); });
    document.openProject("work", project);
    return QCoreApplication::exec();
}
