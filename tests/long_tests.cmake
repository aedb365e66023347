# What `tools/test` leaves out and `tools/test --all` runs: the slowest cases, each with a similar one that `tools/test` keeps. They become a
# test KIND.NAME_long with the label `long`. So are soak.headless, consumer.headers, replay.slurm, replay.window_tour, three of replay.light_of_LEVEL and three of bench, which are
# labelled where they are added. Comments say what stays.
#
# LANTHORN_LONG_KIND_NAME: cases as --gtest_filter names them.

# Every level's tour: red-wall's stays, and the recordings of all.
# And a start without anything in the caches of OpenGL: it compiles for as long as it is meant to spare.
set(LANTHORN_LONG_gpu_game_tour Tour.SolvesEveryLevelAndShowsThem Prepare.SaysAndKeepsWhichLevelIsPrepared)
# Three scenes of five: clutter stays by both final stages, cornell by splats and two-rooms by gathering.
set(LANTHORN_LONG_gpu_headlines
    Scenes/Headlines.*_dark Scenes/Headlines.*_lantern_room Scenes/Headlines.*_nave Scenes/Headlines.*splat_two_rooms
    Scenes/Headlines.*gather_cornell)
# Each stays with one final stage; this is the other.
set(LANTHORN_LONG_gpu_gather_hardships
    FinalStages/Hardships.AHundredLampsLightARoom/gather FinalStages/Hardships.ALampSwitchedOnAfterABlackMinuteIsRightAtOnce/splat
    FinalStages/Hardships.AnotherViewAndLampAfterTheDark/splat FinalStages/Hardships.ACameraThatJumpsBetweenRoomsSeesNoOtherRoomsLight/splat
    FinalStages/Hardships.AnotherSizeInEveryFrame/gather FinalStages/Hardships.MapsAreGivenUpAndTakenBackWhileRunning/gather
    FinalStages/Hardships.WhatJumpsAwayLeavesNoGhostForLong/splat FinalStages/Hardships.LampCameraAndFigureMoveAtOnce/splat)
# Spheres of closed form: the least and the most bounces and albedo stay.
set(LANTHORN_LONG_gpu_gi
    Bounces/ClosedSphere.*/1 Bounces/ClosedSphere.*/2 Bounces/ClosedSphere.*/3 Bounces/ClosedSphere.*/4 Bounces/ClosedSphere.*/5
    Bounces/ClosedSphere.*/6 Albedos/GlowingCavity.*/1 Albedos/GlowingCavity.*/2 Radii/SmallBall.*/1)
set(LANTHORN_LONG_gpu_gather
    Bounces/GatheredSphere.*/1 Bounces/GatheredSphere.*/2 Bounces/GatheredSphere.*/3 Bounces/GatheredSphere.*/4 Bounces/GatheredSphere.*/5
    Bounces/GatheredSphere.*/6)
set(LANTHORN_LONG_gpu_lit_photons
    Bounces/PhotonLitSphere.*/1 Bounces/PhotonLitSphere.*/2 Bounces/PhotonLitSphere.*/3 Bounces/PhotonLitSphere.*/4)
# Plain reflections by the maps' rays: by exact rays they stay, and the coarser grid by both.
set(LANTHORN_LONG_gpu_specular Rays/Specular.AMetalFloorUnderAnEvenSkyReflectsItsShare/maps Rays/Specular.AMirrorShowsWhatACameraBehindItSees/maps)
# A second scene.
set(LANTHORN_LONG_gpu_presets Scenes/Presets.ErrFallsAsWorkRises/two_rooms)
# With indirect light, whose noise is judged as well, and a second level: rest, walk and pan stay.
set(LANTHORN_LONG_gpu_upscaled
    Scenes/Upscaled.*/poolrest Scenes/Upscaled.*/redwalllitrest Scenes/Upscaled.*/furnishedwalk Scenes/Upscaled.*/tworoomsbox
    Scenes/Upscaled.*/puppetfigure)
# Seven levels of nine: red-wall and mirrors stay.
set(LANTHORN_LONG_gpu_editor
    Levels/Pictures.*/Level1 Levels/Pictures.*/Level2 Levels/Pictures.*/Level3 Levels/Pictures.*/Level4 Levels/Pictures.*/Level6
    Levels/Pictures.*/Level7 Levels/Pictures.*/Level8)
# Two walks of which one stays.
set(LANTHORN_LONG_gpu_many_rooms ManyRooms.AWalkIsTheSameInEveryRun)
# A room that drives: one world around it stays, and a camera that is left behind.
set(LANTHORN_LONG_gpu_maps_keep_up Worlds/DrivingRoom.*/in_0_m_at_a_walk Worlds/DrivingRoom.*/in_0_m_at_a_run Worlds/DrivingRoom.*/in_3000_*)
# Sizes between others that stay, and by the other final stage; extremes.shipped has all of them by the default.
set(LANTHORN_LONG_extremes_gi
    Gi/Extremes.Holds/a_million_photons Gi/Extremes.Holds/k___32__* Gi/Extremes.Holds/a_block_inside_out
    Gi/Extremes.Holds/eye_5_mm_above_the_floor Gather/GatheredExtremes.Holds/*in_a_*box_of_10* Gather/GatheredExtremes.Holds/in_a_box_of_50_m
    Gather/GatheredExtremes.Holds/a_triangle_10* Gather/GatheredExtremes.Holds/scaled_by_* Gather/GatheredExtremes.Holds/moved_*)
# Sizes between others that stay.
set(LANTHORN_LONG_extremes_shipped
    Rows/ShippedExtremes.Hold/a_million_photons Rows/ShippedExtremes.Hold/k___32* Rows/ShippedExtremes.Hold/scaled_by_*
    Rows/ShippedExtremes.Hold/moved_by_1e_0* Rows/ShippedExtremes.Hold/in_a_box_of_10* Rows/ShippedExtremes.Hold/in_a_box_of_50_m
    Rows/ShippedExtremes.Hold/a_triangle_10_m_away Rows/ShippedExtremes.Hold/a_triangle_100_m_away)
# What another case of the same window asks in another way.
set(LANTHORN_LONG_gpu_game_window
    DevicesInAWindow.TheViewStaysWhenTheGameGoesOnWithThePointerElsewhere AtTheScreens.ALevelWhoseFileIsGoneIsLeftAsAnyOther
    StoppedInAWindow.WhatWasPlayedIsReplayed)

# LANTHORN_COST_KIND_NAME: seconds that a test takes beside another on two cores, if more than 20: the slowest start first, so that both cores
# are busy to the end also where nothing was measured before. Tests that are no GoogleTest programs say it where they are added.
set(LANTHORN_COST_gpu_editor_window 160)
set(LANTHORN_COST_gpu_game_tour 115)
set(LANTHORN_COST_replay_pictures 100)
set(LANTHORN_COST_extremes_gi 92)
set(LANTHORN_COST_gpu_presets 90)
set(LANTHORN_COST_gpu_specular 85)
set(LANTHORN_COST_extremes_shipped 82)
set(LANTHORN_COST_gpu_gather 74)
set(LANTHORN_COST_gpu_costs_and_turntables 74)
set(LANTHORN_COST_gpu_gi 72)
set(LANTHORN_COST_gpu_lit_photons 71)
set(LANTHORN_COST_gpu_command_line 65)
set(LANTHORN_COST_gpu_gather_hardships 63)
set(LANTHORN_COST_gpu_game 62)
set(LANTHORN_COST_gpu_views 62)
set(LANTHORN_COST_gpu_sky 60)
set(LANTHORN_COST_gpu_caustics 58)
set(LANTHORN_COST_gpu_many_rooms 58)
set(LANTHORN_COST_gpu_game_window 56)
set(LANTHORN_COST_gpu_settings_changes 54)
set(LANTHORN_COST_gpu_maps_keep_up 50)
set(LANTHORN_COST_gpu_shaders 50)
set(LANTHORN_COST_gpu_headlines 50)
set(LANTHORN_COST_gpu_splat 49)
set(LANTHORN_COST_extremes_techniques 46)
set(LANTHORN_COST_unit_reference 45)
set(LANTHORN_COST_gpu_doors 42)
set(LANTHORN_COST_gpu_vertex-map 39)
set(LANTHORN_COST_extremes_materials 38)
set(LANTHORN_COST_gpu_drm 37)
set(LANTHORN_COST_gpu_editor 37)
set(LANTHORN_COST_gpu_gather_movers 34)
set(LANTHORN_COST_unit_replay_commands 32)
set(LANTHORN_COST_gpu_gather_still 30)
set(LANTHORN_COST_unit_assets 28)
set(LANTHORN_COST_unit_editor_session 27)
set(LANTHORN_COST_gpu_papers 25)
set(LANTHORN_COST_unit_splat 25)
set(LANTHORN_COST_replay_door_light 25)
set(LANTHORN_COST_gpu_light_sensor 22)
set(LANTHORN_COST_unit_audio 21)
