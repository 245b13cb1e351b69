data/genus3_features.obj parameterized.obj --feature-angle 45
