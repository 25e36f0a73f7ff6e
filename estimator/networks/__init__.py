"""The contact estimator: networks, trees and a Gaussian process, training, intervals (torch)."""
