// EnTT's column, written against its documented interface since version 3.4.
#include <algorithm>
#include <entt/entt.hpp>
#include <random>
#include <vector>

#include "tests/bench/ecs/contender.h"

namespace lanthorn::ecs {
namespace {

class Entt : public Contender {
  public:
    void create(std::size_t count) override {
        all_.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            const entt::entity e = registry_.create();
            registry_.emplace<Position>(e);
            registry_.emplace<Velocity>(e);
            if (i % 2 == 1) {
                registry_.emplace<Heat>(e);
            }
            all_.push_back(e);
        }
    }
    void iterate() override { registry_.view<Position, const Velocity>().each(move); }
    void shuffle() override {
        order_ = all_;
        std::shuffle(order_.begin(), order_.end(), std::mt19937(1));
    }
    float get_in_random_order() override {
        float sum = 0;
        for (const entt::entity e : order_) {
            sum += registry_.get<Velocity>(e).x;
        }
        return sum;
    }
    void add_and_remove() override {
        for (std::size_t i = 0; i < all_.size(); i += 2) {
            registry_.emplace<Heat>(all_[i]);
        }
        for (std::size_t i = 0; i < all_.size(); i += 2) {
            registry_.remove<Heat>(all_[i]);
        }
    }
    void destroy() override {
        for (const entt::entity e : all_) {
            registry_.destroy(e);
        }
    }

  private:
    entt::registry registry_;
    std::vector<entt::entity> all_, order_;
};

}  // namespace

std::unique_ptr<Contender> make_entt() {
    return std::make_unique<Entt>();
}

}  // namespace lanthorn::ecs
