#include "core/pattern/samples.h"
#include "core/simulation/simulation.h"
#include "core/simulation/surroundings.h"
#include "ui/views/style/language.h"

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTranslator>
#include <QXmlStreamReader>
#include <gtest/gtest.h>

#include <algorithm>

namespace knittsim::ui {
namespace {

const QString kFile = QStringLiteral(KNITTSIM_SOURCE_DIR "/resources/translations/knittsim_de.ts");
constexpr const char* kCure =
    "Run 'ninja -C build translations' and write the German of what it marks as unfinished in "
    "resources/translations/knittsim_de.ts; take the mark away.";

struct Text {
    QString context;
    QString source;
    QString german;
    bool finished = false;
};

std::vector<Text> read(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    QXmlStreamReader xml(&file);
    std::vector<Text> texts;
    Text text;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) {
            continue;
        }
        if (xml.name() == QLatin1String("name")) {
            text.context = xml.readElementText();
        } else if (xml.name() == QLatin1String("source")) {
            text.source = xml.readElementText();
        } else if (xml.name() == QLatin1String("translation")) {
            text.finished = !xml.attributes().hasAttribute(QLatin1String("type"));
            text.german = xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
            texts.push_back(text);
        }
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return texts;
}

QStringList places(const QString& text) {
    static const QRegularExpression kPlace(QStringLiteral("%(\\d|n)"));
    QStringList found;
    for (auto matches = kPlace.globalMatch(text); matches.hasNext();) {
        found << matches.next().captured();
    }
    found.removeDuplicates();
    found.sort();
    return found;
}

TEST(Translation, EveryTextOfTheWindowHasItsGerman) {
    QTemporaryDir folder;
    const QString copy = folder.filePath("knittsim_de.ts");
    ASSERT_TRUE(QFile::copy(kFile, copy));
    QFile::setPermissions(copy, QFile::ReadOwner | QFile::WriteOwner);
    QProcess update;
    update.start(QStringLiteral(KNITTSIM_LUPDATE),
                 {"-silent", "-I", KNITTSIM_SOURCE_DIR, "-locations", "none", "-no-obsolete",
                  KNITTSIM_SOURCE_DIR "/ui", KNITTSIM_SOURCE_DIR "/app", "-ts", copy});
    ASSERT_TRUE(update.waitForFinished(120000));
    ASSERT_EQ(update.exitCode(), 0);
    const std::vector<Text> texts = read(copy);
    EXPECT_GT(texts.size(), 500U);
    for (const Text& text : texts) {
        EXPECT_TRUE(text.finished && !text.german.isEmpty())
            << text.context.toStdString() << ": \"" << text.source.toStdString() << "\" has no German. "
            << kCure;
    }
}

TEST(Translation, PlacesForValuesAreTheSame) {
    for (const Text& text : read(kFile)) {
        EXPECT_EQ(places(text.source), places(text.german)) << text.german.toStdString();
        EXPECT_EQ(text.source.contains(u'&'), text.german.contains(u'&')) << text.german.toStdString();
    }
}

/// lupdate names the place where a text stands, the program the one where it asks: they must not differ.
TEST(Translation, ContextsAreThoseTheProgramAsksFor) {
    for (const Text& text : read(kFile)) {
        EXPECT_TRUE(text.context.startsWith(QLatin1String("knittsim::")) || text.context == "main" ||
                    text.context == "messages" || text.context == "beds")
            << text.context.toStdString() << ", see resources/translations/README.md";
    }
}

TEST(Translation, WhatTheCoreNamesHasItsGerman) {
    int count = 0;
    QCoreApplication application(count, nullptr);
    applyLanguage(application, QStringLiteral("de"));
    const auto german = [](const char* context, const std::string& source) {
        return std::ranges::any_of(
            QCoreApplication::instance()->findChildren<QTranslator*>(),
            [&](const QTranslator* of) { return !of->translate(context, source.c_str()).isEmpty(); });
    };
    for (const pattern::Sample& sample : pattern::samples()) {
        EXPECT_TRUE(german("samples", sample.title)) << sample.title << ": core_de.ts";
        EXPECT_TRUE(german("samples", sample.description)) << sample.description << ": core_de.ts";
    }
    for (const simulation::IntegratorInfo& info : simulation::integrators()) {
        EXPECT_TRUE(german("integrators", info.name) && german("integrators", info.purpose)) << info.name;
    }
    for (const simulation::SurroundingsInfo& info : simulation::surroundingsKinds()) {
        EXPECT_TRUE(german("surroundings", info.name) && german("surroundings", info.purpose)) << info.name;
    }
    applyLanguage(application, QStringLiteral("en"));
}

} // namespace
} // namespace knittsim::ui
