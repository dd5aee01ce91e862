#pragma once

#include "core/fabric/fabric_builder.h"
#include "core/fabric/needle_hooks.h"

#include <QObject>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace knittsim::document {

class Mailbox;

/// The fabric after the first operations of a program, and where its table entries lie in the whole fabric.
struct PrefixFabric {
    machine::OperationIndex count = 0;
    std::shared_ptr<const fabric::Fabric> fabric;
    std::shared_ptr<const fabric::Fabric> whole; ///< with which it was paired
    std::vector<fabric::EntryIndex>
        wholeEntry;                      ///< by entry of `fabric`; -1 where the whole has no such place
    std::vector<fabric::HeldStack> held; ///< what hangs on the needles
};

/// Pairs the entries of a prefix with those of the whole fabric by the history of their points.
std::vector<fabric::EntryIndex> pairEntries(const fabric::Fabric& prefix, const fabric::Fabric& whole);

/// Positions (3 per entry, mm) of a prefix taken from those of the whole fabric. Entries that the whole does
/// not have lie beside their neighbours on the yarn as the machine left them.
std::vector<float> prefixPositions(const PrefixFabric& prefix, std::span<const float> whole);

/// Builds prefixes in the background, one at a time; of waiting requests only the latest counts.
class PrefixBuilder : public QObject {
    Q_OBJECT

public:
    explicit PrefixBuilder(QObject* parent = nullptr);
    ~PrefixBuilder() override;

    void request(std::shared_ptr<const machine::Timeline> timeline,
                 std::shared_ptr<const fabric::Fabric> whole, machine::OperationIndex count);

    /// Forgets what waits and what is being built.
    void cancel();

signals:
    void built(std::shared_ptr<const knittsim::document::PrefixFabric> prefix);

private:
    struct Request {
        std::shared_ptr<const machine::Timeline> timeline;
        std::shared_ptr<const fabric::Fabric> whole;
        machine::OperationIndex count = 0;
    };

    void startNext();

    std::shared_ptr<Mailbox> m_mailbox;
    std::optional<Request> m_waiting;
    std::uint64_t m_generation = 0;
    bool m_busy = false;
};

} // namespace knittsim::document
