#pragma once

#include "core/base/result.h"
#include "core/machine/carrier_yarns.h"
#include "core/machine/profile.h"
#include "core/machine/program.h"
#include "core/pattern/chart.h"

namespace knittsim::pattern {

/// A program in the words of a chart.
struct LiftInput {
    std::vector<machine::Operation> operations; ///< needles as wales, carriers as yarns; no colours at the
                                                ///< beginning, nothing that sets what is set already
    const std::vector<std::string>* texts = nullptr; ///< of the program
    std::vector<ChartYarn> yarns;
    int firstNeedle = 0; ///< of wale 0
    int wales = 0;
    Diagnostics notes; ///< KS0513
};

/// Errors: KS0510, KS0512, KS0514, KS0515.
Result<LiftInput> liftInput(const machine::Program& program, const machine::MachineProfile& machine,
                            const std::vector<machine::CarrierYarn>& yarns);

} // namespace knittsim::pattern
