#pragma once

#include <gtest/gtest.h>

#include <string>

#include "lanthorn/ecs/error.h"

// Runs `statement`, expects an ecs::Error whose text holds `part`.
#define EXPECT_ECS_ERROR(statement, part)                                                                \
    try {                                                                                                \
        statement;                                                                                       \
        ADD_FAILURE() << "no error";                                                                     \
    } catch (const lanthorn::ecs::Error& error) {                                                        \
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << "error: " << error.what(); \
    }
