// Where maps are reserved, on rays and places that can be counted by hand.
#include "gi_module/techniques/emc/maps/reserved_centres.h"

#include <gtest/gtest.h>

namespace lanthorn::gi {
namespace {

UnseenSurvey survey_of(const std::vector<float>& rays, double all = 1000) {
    UnseenSurvey survey;
    survey.rays = all;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        survey.places.push_back(
            {vec3(static_cast<float>(i), 1, 0), vec3(static_cast<float>(i), 0, 0), rays[i]});
        survey.unseen += static_cast<double>(rays[i]);
    }
    return survey;
}

TEST(ReservedCentres, OneRayInTwoThousandIsWorthALook) {
    EXPECT_FALSE(lacks_maps({}));
    EXPECT_FALSE(lacks_maps(survey_of({4}, 10000)));
    EXPECT_TRUE(lacks_maps(survey_of({6}, 10000)));
}

TEST(ReservedCentres, AreTriedInTheMiddleOfRays) {
    UnseenSurvey survey;
    survey.rays = 100;
    // Three near each other outweigh a stronger one that is alone.
    survey.places = {{vec3(0, 2, 0), vec3(0, 0, 0), 4},
                     {vec3(0.1f, 2, 0), vec3(0.1f, 0, 0), 5},
                     {vec3(0.2f, 2, 0), vec3(0.2f, 0, 0), 4},
                     {vec3(8, 0.1f, 0), vec3(8, 0, 0), 6}};
    const std::vector<vec3> centres = trial_centres(survey, 10, 8);
    // Of the first, the middle of the ray and a fiftieth of the diagonal off its place; the other's middle is
    // near.
    ASSERT_EQ(centres.size(), 3u);
    EXPECT_EQ(centres[0], vec3(0.1f, 1, 0));
    EXPECT_NEAR(glm::distance(centres[1], vec3(0.1f, 0.2f, 0)), 0, 1e-5);
    EXPECT_EQ(centres[2], vec3(8, 0.05f, 0));
    EXPECT_LE(trial_centres(survey, 10, 2).size(), 2u);
    EXPECT_TRUE(trial_centres({}, 10, 8).empty());
}

TEST(ReservedCentres, TheFirstShowsTheMost) {
    const UnseenSurvey survey = survey_of({5, 7, 2});
    const Reservation r =
        reservation(survey, {{true, false, false}, {true, false, true}, {false, false, true}}, 0, 2);
    EXPECT_EQ(r.trial, 1);  // 7 rays; the others show 5 and 2
    EXPECT_EQ(r.replaced, -1);
}

TEST(ReservedCentres, TheSecondShowsWhatTheFirstDoesNot) {
    const UnseenSurvey survey = survey_of({5, 7, 2});
    // In use: 12 rays. The first trial shows 7 of these, the other 2 more.
    const Reservation r =
        reservation(survey, {{true, true, false}, {false, true, false}, {false, false, true}}, 1, 2);
    EXPECT_EQ(r.trial, 2);
    EXPECT_EQ(r.replaced, -1);
}

TEST(ReservedCentres, OneIsMovedOnlyForHalfAsMuchAgain) {
    // In use: 4 and 6 rays. A trial in the place of the first makes 6 + 8 of 10, less than half as much
    // again.
    const std::vector<std::vector<bool>> seen{
        {true, false, false}, {false, true, false}, {false, false, true}};
    EXPECT_EQ(reservation(survey_of({4, 6, 8}), seen, 2, 2).trial, -1);
    const Reservation r = reservation(survey_of({4, 6, 10}), seen, 2, 2);
    EXPECT_EQ(r.trial, 2);
    EXPECT_EQ(r.replaced, 0);
}

TEST(ReservedCentres, HardlyAnyRaysAreNotWorthOne) {
    EXPECT_EQ(reservation(survey_of({4}, 10000), {{true}}, 0, 2).trial, -1);
    EXPECT_EQ(reservation(survey_of({6}, 10000), {{true}}, 0, 2).trial, 0);
    EXPECT_EQ(reservation(survey_of({6}), {{false}}, 0, 2).trial, -1);
    EXPECT_EQ(reservation(survey_of({6}), {}, 0, 2).trial, -1);
}

}  // namespace
}  // namespace lanthorn::gi
