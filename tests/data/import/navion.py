"""The Navion, longitudinal.
A = [[1, 2], [3, 4]] stands here in words only.
"""
import numpy as np
from numpy import array

# units: SI
speed = 53.644800000000004   # m/s
states = ["du", "dw", "dq", "dtheta"]
inputs = ['delta_e', 'thrust']
A = np.array([[-0.0450489537536, 0.03603916300287998, 0.0, -9.8066352],
              [-0.36940142077951993, -2.02269802353664, 53.644800000000004, 0.0],
              [0.006259911979787556, -0.1296581657940504, -2.9857526358528004, 0.0],
              [0.0, 0.0, 1.0, 0.0]], dtype=float)
B = np.array([[0.0, -8.57907950583998, -11.056677380684677, 0.0], [9.8066352, 0.0, 0.0, 0.0]]).T
print(np.linalg.eigvals(A))
