#pragma once

#include "core/base/diagnostic.h"
#include "core/fabric/fabric.h"
#include "core/machine/carrier_yarns.h"
#include "core/machine/checks/check.h"
#include "core/machine/timeline.h"
#include "core/pattern/project.h"
#include "core/yarn/yarn_library.h"
#include "ui/document/source_text.h"
#include "ui/document/stitch_grid.h"

#include <QObject>
#include <QString>

#include <memory>
#include <vector>

namespace knittsim::document {

class Mailbox;
using machine::CarrierYarn;

/// What is to be opened: a file, a text with a title, or a chart.
struct OpenRequest {
    QString path;         ///< empty for what is not in a file yet
    QString title;        ///< as the window shows it
    QString text;         ///< knitout; empty for a file and for a chart
    QString machine = {}; ///< id of the profile; empty: what the file names
    std::shared_ptr<const pattern::Project> project = {};
    bool asChart = false; ///< a file or a text: lifted into a chart
};

/// All that is made from one file, off the window's thread. Immutable.
struct OpenedFile {
    OpenRequest request;
    Diagnostics diagnostics;             ///< of reading and of the machine
    std::vector<machine::Waived> waived; ///< by the machine profile
    QString machineOfFile;               ///< name of the profile that the file itself means
    std::shared_ptr<const SourceText> source;
    std::shared_ptr<const machine::Timeline> timeline; ///< null when the file could not be read
    std::shared_ptr<const fabric::Fabric> fabric;      ///< null with the timeline
    std::shared_ptr<const StitchGrid> grid;            ///< null with the timeline
    std::vector<CarrierYarn> carriers;
    std::shared_ptr<const pattern::Project> project; ///< null where there is machine data only
    std::vector<float> shape;                        ///< at rest, as the file has kept it; may be empty
    std::vector<OperationIndex> chartCourseEnds;     ///< operations done after each course of the chart
    std::vector<OperationIndex> passEnds;            ///< operations done after each pass, rising
    std::vector<OperationIndex> courseEnds;          ///< operations done after each course, rising

    bool readable() const { return timeline != nullptr; }
};

enum class OpeningStage { Reading, Machine, Fabric };

/// The whole way from a file to a fabric. Pure but for reading; any thread. `stage` is told where the work
/// is. A chart that cannot be knitted makes no fabric; where `keepChart` is set it opens all the same, with
/// an empty program, so that it can be mended.
std::shared_ptr<const OpenedFile> openFile(const OpenRequest& request, const yarn::YarnLibrary& library,
                                           const std::function<void(OpeningStage)>& stage = {},
                                           bool keepChart = true);

/// Runs openFile in the background; a newer request or cancel() makes an older one unheard.
class Opener : public QObject {
    Q_OBJECT

public:
    explicit Opener(std::shared_ptr<const yarn::YarnLibrary> library, QObject* parent = nullptr);
    ~Opener() override;

    /// For files that are opened from now on.
    void setLibrary(std::shared_ptr<const yarn::YarnLibrary> library) { m_library = std::move(library); }
    void open(const OpenRequest& request, bool keepChart = true);
    void cancel();
    bool busy() const { return m_busy; }

signals:
    void stageChanged(knittsim::document::OpeningStage stage);
    void finished(std::shared_ptr<const knittsim::document::OpenedFile> file);

private:
    std::shared_ptr<const yarn::YarnLibrary> m_library;
    std::shared_ptr<Mailbox> m_mailbox;
    std::uint64_t m_generation = 0;
    bool m_busy = false;
};

} // namespace knittsim::document
