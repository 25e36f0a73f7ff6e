"""Quality of estimators, beside what is possible at best."""
