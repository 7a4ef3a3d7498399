"""The algorithm and its contracts; knows no robot, no simulator and no learner."""
