#include <algorithm>
#include <random>
#include <vector>

#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/world.h"
#include "tests/bench/ecs/contender.h"

namespace lanthorn::ecs {
namespace {

class Lanthorn : public Contender {
  public:
    void create(std::size_t count) override {
        all_.reserve(count);
        for (std::size_t i = 0; i < count / 2; ++i) {
            all_.push_back(world_.create(Position{}, Velocity{}));
            all_.push_back(world_.create(Position{}, Velocity{}, Heat{}));
        }
    }
    void iterate() override { world_.query<Write<Position>, Read<Velocity>>().each(move); }
    void shuffle() override {
        order_ = all_;
        std::shuffle(order_.begin(), order_.end(), std::mt19937(1));
    }
    float get_in_random_order() override {
        float sum = 0;
        for (const Entity e : order_) {
            sum += world_.get<Velocity>(e).x;
        }
        return sum;
    }
    void add_and_remove() override {
        for (std::size_t i = 0; i < all_.size(); i += 2) {
            world_.add(all_[i], Heat{});
        }
        for (std::size_t i = 0; i < all_.size(); i += 2) {
            world_.remove<Heat>(all_[i]);
        }
    }
    void destroy() override {
        for (const Entity e : all_) {
            world_.destroy(e);
        }
    }

  private:
    World world_;
    std::vector<Entity> all_, order_;
};

}  // namespace

std::unique_ptr<Contender> make_lanthorn() {
    return std::make_unique<Lanthorn>();
}

}  // namespace lanthorn::ecs
