// What most tests include, compiled once (a precompiled header): include it nowhere, and in a test whatever
// it uses.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "lanthorn/ecs/schedule.h"
#include "lanthorn/scene/frame_scene.h"
