#include "ui/document/step_marks.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace knittsim::document {

namespace {

using machine::OperationKind;

const QString kBookmarks = QStringLiteral("bookmarks");
const QString kFrom = QStringLiteral("from");
const QString kTo = QStringLiteral("to");
const QString kKinds = QStringLiteral("kinds");
const QString kNeedle = QStringLiteral("needle");
const QString kCarrier = QStringLiteral("carrier");
const QString kRacked = QStringLiteral("racked");
const QString kProblem = QStringLiteral("problem");

QString nameOf(OperationKind kind) {
    return QString::fromUtf8(toString(kind));
}

void write(QJsonObject& object, const StopRules& rules) {
    QJsonArray kinds;
    for (int i = 0; i < machine::kOperationKindCount; ++i) {
        if (const auto kind = static_cast<OperationKind>(i); rules.has(kind)) {
            kinds.append(nameOf(kind));
        }
    }
    object[kKinds] = kinds;
    if (rules.needle) {
        object[kNeedle] = QString::fromStdString(machine::toString(*rules.needle));
    }
    if (rules.carrier) {
        object[kCarrier] = static_cast<int>(*rules.carrier);
    }
    object[kRacked] = rules.racked;
    object[kProblem] = rules.problem;
}

StopRules readRules(const QJsonObject& object) {
    StopRules rules;
    const QJsonArray kinds = object[kKinds].toArray();
    for (int i = 0; i < machine::kOperationKindCount; ++i) {
        const auto kind = static_cast<OperationKind>(i);
        rules.set(kind, kinds.contains(nameOf(kind)));
    }
    rules.needle = needleFromText(object[kNeedle].toString().toStdString());
    if (const int carrier = object[kCarrier].toInt(-1); carrier >= 0 && carrier <= UINT8_MAX) {
        rules.carrier = static_cast<machine::CarrierIndex>(carrier);
    }
    rules.racked = object[kRacked].toBool();
    rules.problem = object[kProblem].toBool();
    return rules;
}

} // namespace

void StepMarks::clear() {
    m_bookmarks.clear();
    m_from = m_to = kNone;
    m_rules.carrier.reset();
    emit changed();
}

void StepMarks::endAt(Step end) {
    const auto behind = m_bookmarks.upper_bound(end);
    if (behind == m_bookmarks.end() && m_from <= end && m_to <= end) {
        return;
    }
    m_bookmarks.erase(behind, m_bookmarks.end());
    m_to = std::min(m_to, end);
    if (m_from > end || m_from == m_to) {
        m_from = m_to = kNone;
    }
    emit changed();
}

void StepMarks::toggleBookmark(Step step) {
    if (m_bookmarks.erase(step) == 0) {
        m_bookmarks.insert(step);
    }
    emit changed();
}

void StepMarks::setBookmarks(std::set<Step> steps) {
    m_bookmarks = std::move(steps);
    emit changed();
}

StepMarks::Step StepMarks::bookmarkFrom(Step step, int direction) const {
    if (direction > 0) {
        const auto found = m_bookmarks.upper_bound(step);
        return found == m_bookmarks.end() ? kNone : *found;
    }
    const auto found = m_bookmarks.lower_bound(step);
    return found == m_bookmarks.begin() ? kNone : *std::prev(found);
}

void StepMarks::setLoopFrom(Step step) {
    m_from = step;
    m_to = m_to > step ? m_to : kNone;
    emit changed();
}

void StepMarks::setLoopTo(Step step) {
    m_to = step;
    m_from = m_from < step ? m_from : kNone;
    emit changed();
}

void StepMarks::endLoop() {
    m_from = m_to = kNone;
    emit changed();
}

void StepMarks::setRules(const StopRules& rules) {
    m_rules = rules;
    emit changed();
}

QByteArray StepMarks::save() const {
    QJsonArray bookmarks;
    for (const Step step : m_bookmarks) {
        bookmarks.append(step);
    }
    QJsonObject object{{kBookmarks, bookmarks}, {kFrom, m_from}, {kTo, m_to}};
    write(object, m_rules);
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

bool StepMarks::restore(const QByteArray& text) {
    const QJsonDocument read = QJsonDocument::fromJson(text);
    if (!read.isObject()) {
        return false;
    }
    const QJsonObject object = read.object();
    m_bookmarks.clear();
    for (const auto& value : object[kBookmarks].toArray()) {
        if (const int step = value.toInt(kNone); step >= 0) {
            m_bookmarks.insert(step);
        }
    }
    m_from = std::max(kNone, object[kFrom].toInt(kNone));
    m_to = std::max(kNone, object[kTo].toInt(kNone));
    m_rules = readRules(object);
    emit changed();
    return true;
}

StepMarks::Move StepMarks::play(const StopFinder& finder, Step from, int due, Step end) const {
    const bool inLoop = loops() && from < m_to;
    const Step last = inLoop ? m_to : end;
    const Step target = std::min(from + due, last);
    if (const auto stop = finder.first(m_rules, from, target); stop >= 0) {
        return {stop + 1, true};
    }
    // The end of the range is seen before it begins again.
    if (loops() && from >= m_to && due > 0) {
        return {m_from, false};
    }
    return {target, target == end && !loops()};
}

} // namespace knittsim::document
