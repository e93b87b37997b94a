# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic rectangle by finite elements, plane strain: products of quadratic elements along x and y, so that all is made of 1D matrices."""

import numpy as np
import scipy.sparse as sparse


def line_matrices(length, elements):
    """Places of the nodes, and int phi phi, int phi' phi', int phi' phi of quadratic elements on a line."""
    h = length / elements
    mass = h / 30 * np.array([[4, 2, -1], [2, 16, 2], [-1, 2, 4]])
    stiff = 1 / (3 * h) * np.array([[7, -8, 1], [-8, 16, -8], [1, -8, 7]])
    mixed = 1 / 6 * np.array([[-3, -4, 1], [4, 0, -4], [-1, 4, 3]])  # row: differentiated
    n = 2 * elements + 1
    rows = np.concatenate([np.repeat(np.arange(3), 3) + 2 * e for e in range(elements)])
    columns = np.concatenate([np.tile(np.arange(3), 3) + 2 * e for e in range(elements)])
    made = [sparse.csr_matrix((np.tile(m.ravel(), elements), (rows, columns)), shape=(n, n)) for m in (mass, stiff, mixed)]
    return np.linspace(0, length, n), made


class Rectangle:
    """0 <= x <= length, 0 <= y <= height. Unknowns: u_x of all nodes, then u_y; a node's number is i * (nodes along y) + j."""

    def __init__(self, size, elements, young, poisson):
        self.x, (mx, kx, cx) = line_matrices(size[0], elements[0])
        self.y, (my, ky, cy) = line_matrices(size[1], elements[1])
        shear = young / (2 * (1 + poisson))
        lame = young * poisson / ((1 + poisson) * (1 - 2 * poisson))
        kron = sparse.kron
        xx = (lame + 2 * shear) * kron(kx, my) + shear * kron(mx, ky)
        yy = shear * kron(kx, my) + (lame + 2 * shear) * kron(mx, ky)
        xy = lame * kron(cx, cy.T) + shear * kron(cx.T, cy)
        self.stiffness = sparse.bmat([[xx, xy], [xy.T, yy]], format="csc")
        self.nodes = len(self.x) * len(self.y)
        self.weights = np.asarray(kron(mx, my).sum(axis=1)).ravel()  # areas of the nodes [m2]
        self.along_y = np.asarray(my.sum(axis=1)).ravel()  # lengths of the nodes of a vertical side [m]

    def node(self, i, j):
        """Number of the node in column i and row j, which may be negative."""
        return np.arange(self.nodes).reshape(len(self.x), len(self.y))[i, j]
