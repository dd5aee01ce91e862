#pragma once

#include "core/physics/time_stepper.h"

namespace knittsim::physics {

/// Explicit Runge-Kutta with step size control through ARKODE's ERKStep; one step of the method a step.
class RungeKutta : public TimeStepper {
public:
    enum class Table { CashKarp, DormandPrince };

    explicit RungeKutta(Table table) : TimeStepper(sundials::Package::Arkode), m_table(table) {}
    ~RungeKutta() override;
    RungeKutta(const RungeKutta&) = delete;
    RungeKutta& operator=(const RungeKutta&) = delete;

private:
    void create(N_Vector y) override;
    int reset(double scaledTime, N_Vector y) override;
    int advance(N_Vector y, double& scaledTime) override;
    double lastStep() const override;

    Table m_table;
    void* m_memory = nullptr;
};

/// Cash and Karp 5(4): the paper's choice.
struct CashKarp final : RungeKutta {
    CashKarp() : RungeKutta(Table::CashKarp) {}
};

/// Dormand and Prince 5(4).
struct DormandPrince final : RungeKutta {
    DormandPrince() : RungeKutta(Table::DormandPrince) {}
};

} // namespace knittsim::physics
