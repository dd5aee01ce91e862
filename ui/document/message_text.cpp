#include "ui/document/message_text.h"

#include "core/base/message_table.h"

#include <QCoreApplication>
#include <QStringList>

#include <string>

namespace knittsim::document {

namespace {

QString filled(std::string_view pattern, const Diagnostic& diagnostic) {
    const std::string source(pattern);
    const QString translated = QCoreApplication::translate("messages", source.c_str());
    return QString::fromStdString(fillMessage(translated.toStdString(), diagnostic.arguments));
}

} // namespace

QString causeText(const Diagnostic& diagnostic) {
    const Message* message = findMessage(diagnostic.id);
    return message ? filled(message->cause, diagnostic) : QString::fromStdString(diagnostic.id);
}

QString cureText(const Diagnostic& diagnostic) {
    const Message* message = findMessage(diagnostic.id);
    return message && !message->cure.empty() ? filled(message->cure, diagnostic) : QString();
}

QString severityText(Severity severity) {
    switch (severity) {
    case Severity::Info:
        return QCoreApplication::translate("messages", "Note");
    case Severity::Warning:
        return QCoreApplication::translate("messages", "Warning");
    case Severity::Error:
        break;
    }
    return QCoreApplication::translate("messages", "Error");
}

QString placeText(const Place& place) {
    QStringList parts;
    if (place.line > 0) {
        parts << QCoreApplication::translate("messages", "line %1").arg(place.line);
    }
    if (place.course >= 0) {
        parts << QCoreApplication::translate("messages", "course %1").arg(place.course + 1);
    }
    if (!place.needle.empty()) {
        parts << QString::fromStdString(place.needle);
    }
    return parts.join(QStringLiteral(", "));
}

} // namespace knittsim::document
