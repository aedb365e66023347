#include "game/presentation.h"
namespace lanthorn::game {
struct Presentation::Parts {};
Presentation::Presentation(const SceneData&, const Level&, const gpu::GlInfo&) {}
Presentation::~Presentation() = default;
void Presentation::draw(const View&, ivec2, const Settings&) {}
void Presentation::show(ivec2) const {}
ImageF Presentation::picture() const { return {}; }
double Presentation::mean_indirect() const { return 0; }
}
