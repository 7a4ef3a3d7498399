"""Published controllers as tutors, each with the learner round it and the world in which it is judged."""
