#include "ui/views/style/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

/// A static library's resources must be named once; the macro does not work inside a namespace.
static void loadTranslations() {
    Q_INIT_RESOURCE(translations);
}

namespace knittsim::ui {

namespace {

const QString kOwn = QStringLiteral("translatorOfKnittSim");
const QString kOfCore = QStringLiteral("translatorOfCore");
const QString kOfQt = QStringLiteral("translatorOfQt");

void install(QCoreApplication& application, const QString& name, const QString& file, const QString& folder) {
    delete application.findChild<QTranslator*>(name, Qt::FindDirectChildrenOnly);
    auto* translator = new QTranslator(&application);
    translator->setObjectName(name);
    if (translator->load(QLocale(), file, QStringLiteral("_"), folder)) {
        QCoreApplication::installTranslator(translator);
    } else {
        delete translator;
    }
}

} // namespace

QStringList languages() {
    return {QStringLiteral("en"), QStringLiteral("de")};
}

void applyLanguage(QCoreApplication& application, const QString& id) {
    loadTranslations();
    QLocale::setDefault(id.isEmpty() ? QLocale::system() : QLocale(id));
    install(application, kOwn, QStringLiteral("knittsim"), QStringLiteral(":/translations"));
    install(application, kOfCore, QStringLiteral("core"), QStringLiteral(":/translations"));
    install(application, kOfQt, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
}

} // namespace knittsim::ui
