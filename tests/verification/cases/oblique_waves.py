# SPDX-License-Identifier: GPL-3.0-or-later
"""Reflection of oblique P and SV packets by a base of dashpots (Lysmer & Kuhlemeyer 1969).

Angles are from the vertical, lengths of the packet in wave lengths; the box is made so large that what goes down has met the
base at the end, and nothing has met the sides. The part of the P waves is twice their strain energy, from div u.
"""

import numpy as np
from scene_numbers import Numbers
from vtu_file import picture_at

ANGLES = (0, 15, 30, 45, 60)  # [deg]
CELLS = {"P": 1.4, "SV": 1.0}  # size relative to the scene's: what P waves send back as short waves is weak
TAIL = 3.0  # standard deviations: beyond them is 1e-5 of the packet's energy
SCATTER = 0.015  # a packet further off its plane wave (near the critical angle) is compared with its own mean only

shown = {"rows": []}


class Boundary:
    """A half space with tractions rho c_p v_y and rho c_s v_x on its boundary; the waves come down to it."""

    def __init__(self, rock):
        self.c_p, self.c_s = rock.speed("P"), rock.speed("S")
        self.density, self.mu, self.modulus = rock.density, rock.shear_modulus, rock.oedometer

    def reflected(self, wave, angle):
        """Parts of the energy that come back as P and as SV wave; angle [rad]."""
        k_p, k_s = 1 / self.c_p, 1 / self.c_s  # per angular frequency
        k_x = np.sin(angle) * (k_p if wave == "P" else k_s)
        p_y, s_y = np.sqrt(k_p**2 - k_x**2 + 0j), np.sqrt(k_s**2 - k_x**2 + 0j)

        def unbalanced(k_y, u_x, u_y):
            shear = self.mu * (k_y * u_x + k_x * u_y)
            normal = self.modulus * k_y * u_y + (self.modulus - 2 * self.mu) * k_x * u_x
            return np.array([shear + self.density * self.c_s * u_x, normal + self.density * self.c_p * u_y])

        up = np.column_stack([unbalanced(p_y, k_x / k_p, p_y / k_p), unbalanced(s_y, -s_y / k_s, k_x / k_s)])
        if wave == "P":
            down = unbalanced(-p_y, k_x / k_p, -p_y / k_p)
        else:
            down = unbalanced(-s_y, s_y / k_s, k_x / k_s)
        amplitude = np.linalg.solve(up, -down)
        flux = np.array([self.c_p**2 * p_y.real, self.c_s**2 * s_y.real])  # c cos(angle) over amplitude^2, times omega
        return np.abs(amplitude) ** 2 * flux / flux["P SV".split().index(wave)]

    def packet(self, wave, angle, length, width):
        """Mean over the plane waves of a packet, by their energies."""
        sums, total = np.zeros(2), 0.0
        for a in np.linspace(-4, 4, 41):
            for b in np.linspace(-4, 4, 41):
                along, across = 2 * np.pi + a / length, (b / width if width > 0 else 0.0)
                part = np.exp(-a * a - b * b) * (along**2 + across**2) ** 2
                sums += part * self.reflected(wave, angle + np.arctan2(across, along))
                total += part
        return sums / total


def box(rock, wave, angle, numbers):
    """Settings of a run: size of the rock, where the packet starts and when its tail has met the base."""
    c = rock.speed(wave[0])
    length = c / numbers.number("Initial wave/Frequency")
    l, b = (TAIL * length * numbers.number("Initial wave/" + name) for name in ("Length", "Width"))
    high, wide = np.hypot(l * np.cos(angle), b * np.sin(angle)), np.hypot(l * np.sin(angle), b * np.cos(angle))
    time = 2 * high / (c * np.cos(angle))
    way = high * np.tan(angle)  # of the packet along the base, before it has met it and after
    right = wide + way
    if wave == "SV" and np.sin(angle) < rock.speed("S") / rock.speed("P"):
        right = max(right, (rock.speed("P") / rock.speed("S")) ** 2 * way + 1.3 * wide)
    h = CELLS[wave] * numbers.mesh("Resolution/h")
    mesh = {"Width": h * np.ceil((wide + way + right) / h), "Height": h * np.ceil(2 * high / h), "Resolution/h": h}
    return mesh, ("Time/End time=%.6g" % time, "Initial wave/Type=" + wave,
                  "Initial wave/Direction=%.12g" % (np.degrees(angle) - 90), "Initial wave/Centre=%.6f, %.6f" % (wide, high))


def pressure_energy(run, rock):
    """Of the P waves at the end [J/m]: (lambda + 2 mu) (div u)^2 over the area."""
    picture, _ = picture_at(run.directory, "continuum", run.time[-1])
    stress = picture.cell_fields["stress increment xx, yy, xy [Pa]"]
    div = (stress[:, 0] + stress[:, 1]) / (2 * (rock.oedometer - rock.shear_modulus))
    corners = picture.initial()[np.array(picture.cells)]
    area = np.abs(np.prod(corners[:, 2] - corners[:, 0], axis=1))
    return rock.oedometer * np.sum(area * div**2)


def measure(run, rock):
    """Parts of the energy at t = 0 that are there at the end as P and as SV wave."""
    energy = run.file["energy"]
    kinds = [energy["bedrock_" + kind] for kind in ("kinetic", "strain")]
    start = sum(kind.attrs["start"][0] for kind in kinds)
    end = start + sum(kind[-1] for kind in kinds)
    pressure = pressure_energy(run, rock)
    return np.array([pressure, end - pressure]) / start


def check(case, waves=("P", "SV"), angles=ANGLES):
    numbers = Numbers(case.run("numbers", "Time/End time=0.004"))  # of the scene
    rock = numbers.material("rock")
    boundary = Boundary(rock)
    packet = [numbers.number("Initial wave/" + name) for name in ("Length", "Width")]
    critical = np.degrees(np.arcsin(rock.speed("S") / rock.speed("P")))
    for wave in waves:
        for degrees in angles:
            angle = np.radians(degrees)
            mesh, settings = box(rock, wave, angle, numbers)
            run = case.run("%s_%g" % (wave, degrees), *settings, mesh=mesh)
            found, of_packet, of_angle = measure(run, rock), boundary.packet(wave, angle, *packet), boundary.reflected(wave, angle)
            for expected, name in ((of_packet, "packet"), (of_angle, "plane wave")):
                if np.abs(np.sqrt(expected) - np.sqrt(of_packet)).max() > SCATTER:
                    continue
                name = "%s %g deg, against the %s: " % (wave, degrees, name)
                case.within(name + "energy", found.sum(), expected.sum(), 0.02)
                if wave == "P" or degrees < critical:
                    for kind in (0, 1):
                        case.within(name + "root of the part as " + ("P", "SV")[kind],
                                    *np.sqrt([max(found[kind], 0), expected[kind]]), 0.02)
            case.below("%s %g deg: energy residual" % (wave, degrees), run.summary["energy_residual"], 1e-3)
            shown["rows"].append((wave, degrees, np.maximum(found, 0), of_packet))
    shown.update(boundary=boundary, run=run)


def draw(case, figure):
    grid = figure.add_gridspec(2, 3, width_ratios=(1, 1, 1.3))
    fine = np.linspace(0, 62, 250)
    for column, wave in enumerate(("P", "SV")):
        axes = figure.add_subplot(grid[:, column])
        curves = np.sqrt([shown["boundary"].reflected(wave, a) for a in np.radians(fine)])
        rows = [row[1:] for row in shown["rows"] if row[0] == wave]
        for kind, colour in ((0, "#1f5a94"), (1, "#b5482a")):
            axes.plot(fine, curves[:, kind], color=colour, lw=1, label="as " + ("P", "SV")[kind] + ", plane wave")
            axes.plot([r[0] for r in rows], np.sqrt([r[1][kind] for r in rows]), "o", color=colour, label="program")
            axes.plot([r[0] for r in rows], np.sqrt([r[2][kind] for r in rows]), "+", color="k", ms=9, label="its packet")
        axes.set_title(wave + " goes down: root of\nthe energy that comes back", fontsize=9)
        axes.set_xlabel("angle [deg]")
        axes.legend(fontsize=7)
    for row, (when, label) in enumerate(((0.0, "at the start"), (1e9, "at the end"))):
        axes = figure.add_subplot(grid[row, 2])
        picture, time = picture_at(shown["run"].directory, "continuum", when)
        speed = 1000 * np.hypot(*picture.point_fields["velocity [m/s]"][:, :2].T)
        shade = axes.tripcolor(picture.points[:, 0], picture.points[:, 1], speed, shading="gouraud", cmap="magma_r")
        figure.colorbar(shade, ax=axes, label="mm/s", shrink=0.8)
        axes.set_aspect("equal")
        axes.set_title("SV, 60 deg, speed %s (%.2f s)" % (label, time), fontsize=9)
        axes.set_ylabel("y [m]")
    axes.set_xlabel("x [m]")
