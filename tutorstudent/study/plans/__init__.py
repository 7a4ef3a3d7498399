"""What is asked: pipelines, environments, controls, and the plan that they make."""
