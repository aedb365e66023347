#include "engine/deformation/limit_rows.h"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTableFactory.h>

#include <memory>

namespace lanthorn::deform {

namespace Far = OpenSubdiv::Far;

namespace {

// Refined vertices are things numbered as they are.
struct RefinedVertices {
    Sum::Thing operator[](int i) const { return {static_cast<std::uint32_t>(i)}; }
};

SparseRows refined_rows(const Far::TopologyRefiner& refiner, std::size_t controls) {
    // Not by OpenSubdiv's classes without REAL: those cast to a class that the table is not.
    using Factory = Far::StencilTableFactoryReal<float>;
    Factory::Options options;
    options.generateIntermediateLevels = false;
    options.maxLevel = static_cast<unsigned>(refiner.GetMaxLevel()) & 15u;
    const std::unique_ptr<const Far::StencilTableReal<float>> table(Factory::Create(refiner, options));
    SparseRows rows(controls);
    Far::StencilReal<float> stencil = table->GetStencil(0);
    for (int i = 0; i < table->GetNumStencils(); ++i, stencil.Next()) {
        for (int k = 0; k < stencil.GetSize(); ++k) {
            rows.add(static_cast<std::uint32_t>(stencil.GetVertexIndices()[k]), stencil.GetWeights()[k]);
        }
        rows.end_row();
    }
    return rows;
}

SparseRows composed(const std::vector<Sum>& sums, const SparseRows& of, std::size_t columns) {
    SparseRows rows(columns);
    for (const Sum& sum : sums) {
        for (const Term& term : sum.terms) {
            rows.add(of[term.index], term.weight);
        }
        rows.end_row();
    }
    return rows;
}

}  // namespace

LimitRows limit_rows(const Far::TopologyRefiner& refiner, std::size_t controls) {
    const auto count = static_cast<std::size_t>(refiner.GetLevel(refiner.GetMaxLevel()).GetNumVertices());
    std::vector<Sum> position(count), du(count), dv(count);
    Far::PrimvarRefiner(refiner).Limit(RefinedVertices{}, position, du, dv);
    const SparseRows refined = refined_rows(refiner, controls);
    return {composed(position, refined, controls), composed(du, refined, controls),
            composed(dv, refined, controls)};
}

}  // namespace lanthorn::deform
