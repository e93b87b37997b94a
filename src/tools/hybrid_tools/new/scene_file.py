# SPDX-License-Identifier: GPL-3.0-or-later
"""scene.prm: what is simulated of the new section, with every number that is not the user's marked."""

import os

from .monitors import place_monitors


def scene_text(section, title, directory, options):
    parts = [head(section, title), time_and_mesh(section), materials(section), continuum(section)]
    if section.mass is not None:
        parts.append(blocks(section))
    return "\n".join(parts + [motion(section, options), records(section, directory, options)])


def head(section, title):
    return """# %s. Made by hybrid new. Lines marked <- are typical values, not yours: replace them before you trust a result.
# Units: SI unless the name says otherwise. All parameters: doc/parameters.md.
set Title = %s
""" % (title, title)


def time_and_mesh(section):
    from .command import times
    end, step = times(section)
    return """subsection Time
  set End time  = %g%s
  set Time step = %g
end

subsection Mesh
  set File    = section.geo
  set Numbers = Resolution/h = %.10g
end

subsection Model
  set Bedrock = continuum # or pure DDA: triangles, layers (Sides = viscous; needs bedding planes), rigid
  set Blocks  = %s
end
""" % (end, end_words(section), step, section.h, "none      # waves alone" if section.mass is None else "bonded    # or loose; none: waves alone")


def end_words(section):
    record = section.record
    if record.kind == "ricker":
        return ""
    return " # the whole record; 5 to 95 %% of its Arias intensity come from %.3g to %.3g s" % (record.husid(0.05), record.husid(0.95))


def materials(section):
    rows = [("rock", section.rock, "<- jointed sedimentary rock, S waves of %.0f m/s" % section.rock.s_wave_speed)]
    if section.mass is not None:
        low, high = section.mass.polygon.bounds[1::2]
        rows.append(("body", section.body, "<- dense debris, S waves of %.0f m/s; its cohesion holds its height of %.3g m" % (
            section.body.s_wave_speed, high - low)))
        safety = section.belt.safety
        rows.append(("belt", section.belt, "<- clayey shear zone; %s" % (
            "its cohesion gives the factor of safety %.3g at rest (simplified Janbu)" % safety if safety < 1e3 else "at rest nothing drives the mass")))
    text = "subsection Materials\n  set Names = %s\n" % ", ".join(name for name, _, _ in rows)
    for name, m, words in rows:
        lines = [] if name == "belt" else [("Density", m.density), ("Young modulus", m.young_modulus), ("Poisson ratio", m.poisson_ratio)]
        if m.cohesion is not None:
            lines += [("Friction angle", m.friction_angle), ("Cohesion", m.cohesion), ("Tensile strength", m.tensile_strength)]
        text += "  subsection %s # %s\n" % (name, words)
        text += "".join("    set %-16s = %s\n" % (key, number(value)) for key, value in lines) + "  end\n"
    return text + "end\n"


def number(value):
    """2500, 10e9, 0.25."""
    for power in (9, 6, 3):
        if value >= 10 * 10**power or (power == 9 and value >= 1e9):
            return "%ge%d" % (value / 10**power, power)
    return "%g" % value


def continuum(section):
    text = """subsection Continuum
  set Materials = rock
  set Base      = compliant  # the motion comes in, waves go out
  set Sides     = free field # level ground goes on beyond the sides
end
"""
    if section.planes:
        names = {"bedding_%d" % n: name for name, n, _ in section.planes}
        planes = ", ".join(sorted(names, key=lambda n: int(n[8:])))
        text += """
subsection Bedding planes
  set Names            = %s
  set Normal stiffness = 8e9 # <- Pa/m; with Strength = Mohr-Coulomb they also slip and open
  set Shear stiffness  = 3e9 # <-
end
""" % planes
    return text


def blocks(section):
    edge, strength, modulus = section.h, section.body.tensile_strength, section.body.young_modulus
    return """subsection Blocks
  set Material          = body
  set Belt material     = belt
  set Softening slip    = 0.1 # <- m until a joint has its residual strength
  set Fracture energy   = %.2g # <- N/m; blocks of this size resolve it
  set Damping ratio     = 0.05 # <- at Damping frequency, growing with frequency
  set Damping frequency = %.2g
end
""" % (max(10.0, 1.3 * edge * strength**2 / modulus), max(section.record.mean_frequency, 0.1))


def motion(section, options):
    record = section.record
    if record.kind == "ricker":
        peak = options.peak or "0.1 g"
        lines = ["set Type      = ricker", "set Frequency = %g # <-" % record.frequency, "set Peak      = %s%s" % (peak, "" if options.peak else " # <-")]
    else:
        lines = ["set Type      = %s" % record.kind, "set File      = %s" % os.path.basename(record.path)]
        lines += ["set Unit      = %s" % options.unit] if record.kind == "text" else []
        lines += ["set Peak      = %s" % options.peak] if options.peak else []
    lines.append("set Meaning   = outcrop # <- of a free rock surface; incident: the upgoing wave itself, half of it")
    return "subsection Motion\n" + "".join("  %s\n" % line for line in lines) + "end\n"


def lines_of(section):
    """Bedding planes and the ground, but for a mass without planes: what hybrid amplification tells of."""
    if not section.planes and section.mass is not None:
        return ""
    names = sorted({"bedding_%d" % n for _, n, _ in section.planes}, key=lambda name: int(name[8:]))
    names += ["ground"] + ["mass_surface"] * (section.mass is not None)
    return "  set Lines  = %s # for hybrid amplification\n" % "; ".join(names)


def records(section, directory, options):
    points, boreholes = place_monitors(section)
    name = os.path.basename(os.path.abspath(directory))
    def listed(items):
        return "; \\\n               ".join("; ".join(items[k:k + 4]) for k in range(0, len(items), 4))

    return """# S1 to S%d along the ground from left to right, D in the rock below, B1 at the base.
subsection Monitors
  set Points = %s
  set Base   = B1
%send

subsection Boreholes
  set Lines = %s
end

subsection Output
  set Directory        = output/%s
  set Picture interval = %g
end
""" % (sum(key[0] == "S" for key in points), listed(["%s: %.9g, %.9g" % (key, *p) for key, p in points.items()]), lines_of(section),
       listed(["%s: %.9g, %.9g, %.9g, %.9g" % (key, x, top, x, bottom) for key, (x, top, bottom) in boreholes.items()]), name, options.pictures)
