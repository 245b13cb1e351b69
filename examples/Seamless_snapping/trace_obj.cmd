data/genus3_features.obj -o traced
