#pragma once

#include "core/formats/passes/pass.h"
#include "core/formats/passes/pass_rules.h"

#include <string_view>

namespace knittsim::formats::passes {

/// Stitch number, speed, presser and take-down that hold for the next passes.
class Settings {
public:
    explicit Settings(const PassRules& rules)
        : m_rules(rules), m_stitch(rules.stitch), m_transferStitch(rules.transferStitch),
          m_speed(rules.speed), m_roller(rules.roller) {}

    /// False, and no change, for a number outside the machine's table.
    bool setStitch(double number);

    /// Takes the text of an extension. False when it is one of those known here with a value out of range.
    bool read(std::string_view text);

    static bool isEndPass(std::string_view text);

    /// A pass with the present stitch number and speed and nothing else.
    Pass pass() const;

    int stitch() const { return m_stitch; }
    int transferStitch() const { return m_transferStitch; }
    bool fourPasses() const { return m_fourPasses; }
    Presser presser() const { return m_rules.presser ? m_presser : Presser::Unset; }
    double roller() const { return m_roller + m_addedRoller; }
    double addedRoller() const { return m_addedRoller; }

    /// What was meant for one pass only has been used.
    void passMade() { m_addedRoller = 0; }

private:
    bool readPresser(std::string_view value);

    PassRules m_rules;
    int m_stitch;
    int m_transferStitch;
    double m_speed;
    double m_roller;
    double m_addedRoller = 0;
    bool m_fourPasses = true;
    Presser m_presser = Presser::Off;
};

} // namespace knittsim::formats::passes
