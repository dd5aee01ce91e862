// The program may die at any moment: no file is damaged, and never more than the last ten seconds are lost.

#include "ui/document/recovery.h"

#include <QDir>
#include <QElapsedTimer>
#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace knittsim::document {

namespace {

constexpr int kKills = 200;
constexpr int kAtOnce = 20;
constexpr int kLatestKillMs = 8000; ///< some copies are written until then
constexpr qint64 kMostLostMs = 10'000;

int numberIn(const pattern::Chart& chart) {
    int number = 0;
    for (int wale = 0; wale < chart.width; ++wale) {
        number |= chart.at(wale, 0).stitch == pattern::Stitch::Purl ? 1 << wale : 0;
    }
    return number;
}

/// One program at work, and when it began each edit.
class Victim {
public:
    explicit Victim(int killAfterMs) : m_killAfterMs(killAfterMs) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("KNITTSIM_CONFIG_DIR", m_folder.path());
        environment.insert("OMP_NUM_THREADS", "1");
        m_process.setProcessEnvironment(environment);
        QObject::connect(&m_process, &QProcess::readyReadStandardOutput, &m_process, [this] { read(); });
        m_process.start(KNITTSIM_KILL_CHILD, {saved()});
    }

    bool dead() const { return m_killed; }
    QString saved() const { return m_folder.filePath("saved.knitt"); }
    QStringList copies() const {
        QStringList paths;
        const QDir folder(m_folder.filePath("recovery"));
        for (const QString& name : folder.entryList({"*.knitt"}, QDir::Files)) {
            paths << folder.filePath(name);
        }
        return paths;
    }
    int edits() const { return static_cast<int>(m_edits.size()); }
    /// Since the first edit that is in none of the files.
    qint64 lostMs(int kept) const {
        return kept < edits() ? m_killedAt - m_edits[static_cast<std::size_t>(kept)] : 0;
    }

    /// The clock begins with the first edit.
    void killWhenDue() {
        if (!m_killed && !m_edits.empty() && m_clock.elapsed() >= m_killAfterMs) {
            m_process.kill();
            m_killedAt = m_clock.elapsed();
            m_process.waitForFinished();
            read();
            m_killed = true;
        }
    }

private:
    void read() {
        while (m_process.canReadLine()) {
            m_process.readLine();
            if (m_edits.empty()) {
                m_clock.start();
            }
            m_edits.push_back(m_clock.elapsed());
        }
    }

    QTemporaryDir m_folder;
    QProcess m_process;
    QElapsedTimer m_clock;
    std::vector<qint64> m_edits; ///< ms, when edit i + 1 was told
    int m_killAfterMs;
    qint64 m_killedAt = 0;
    bool m_killed = false;
};

} // namespace

class KillTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsKilledLosesLittleAndDamagesNothing() {
        QRandomGenerator random(20260);
        qint64 mostLost = 0;
        int copies = 0;
        int saves = 0;
        for (int done = 0; done < kKills; done += kAtOnce) {
            std::vector<std::unique_ptr<Victim>> victims;
            for (int i = 0; i < kAtOnce; ++i) {
                victims.push_back(std::make_unique<Victim>(random.bounded(kLatestKillMs)));
            }
            QTRY_VERIFY_WITH_TIMEOUT(
                [&] {
                    for (const auto& victim : victims) {
                        victim->killWhenDue();
                    }
                    return std::ranges::all_of(victims, [](const auto& victim) { return victim->dead(); });
                }(),
                120'000);
            for (const auto& victim : victims) {
                int kept = 0;
                QStringList files = victim->copies();
                copies += static_cast<int>(files.size());
                if (QFile::exists(victim->saved())) {
                    files << victim->saved();
                    ++saves;
                }
                for (const QString& file : files) {
                    const auto read = pattern::readProjectFile(file.toStdString());
                    QVERIFY2(bool(read), qPrintable(file));
                    kept = std::max(kept, numberIn(read.value().chart));
                }
                QVERIFY(kept <= victim->edits());
                QVERIFY2(victim->lostMs(kept) <= kMostLostMs,
                         qPrintable(QString("%1 ms").arg(victim->lostMs(kept))));
                mostLost = std::max(mostLost, victim->lostMs(kept));
            }
        }
        qInfo("%d killed, %d copies and %d saved files read; most lost: %lld ms", kKills, copies, saves,
              static_cast<long long>(mostLost));
        QVERIFY2(copies > kKills / 10, "the kills came before anything was kept");
    }
};

} // namespace knittsim::document

QTEST_GUILESS_MAIN(knittsim::document::KillTest)
#include "kill_test.moc"
