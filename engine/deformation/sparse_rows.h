// Sums of numbered things, and sums of such sums.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lanthorn::deform {

struct Term {
    std::uint32_t index;
    float weight;
};

// One sum, as OpenSubdiv's PrimvarRefiner writes it.
struct Sum {
    struct Thing {
        std::uint32_t index;
    };
    std::vector<Term> terms;

    void Clear() { terms.clear(); }
    void AddWithWeight(const Thing& thing, float weight) { terms.push_back({thing.index, weight}); }
};

// Many sums of `columns` things, one after another.
class SparseRows {
  public:
    explicit SparseRows(std::size_t columns) : at_(columns, 0.0), used_(columns, 0) {}

    std::size_t size() const { return ends_.size(); }
    std::span<const Term> operator[](std::size_t row) const {
        const std::size_t first = row == 0 ? 0 : ends_[row - 1];
        return {terms_.data() + first, ends_[row] - first};
    }
    // Adds `weight` times a thing, or a row of things, to the row that end_row() then ends.
    void add(std::uint32_t index, double weight) {
        if (!used_[index]) {
            used_[index] = 1;
            touched_.push_back(index);
        }
        at_[index] += weight;
    }
    void add(std::span<const Term> row, double weight) {
        for (const Term& term : row) {
            add(term.index, weight * term.weight);
        }
    }
    // Terms are in ascending order of their index.
    void end_row();

  private:
    std::vector<Term> terms_;
    std::vector<std::size_t> ends_;
    std::vector<double> at_;  // of the row under way
    std::vector<char> used_;
    std::vector<std::uint32_t> touched_;
};

}  // namespace lanthorn::deform
