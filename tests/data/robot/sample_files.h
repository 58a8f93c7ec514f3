#pragma once

/// Robots of other programs' formats with much of what these can say, for tests of all of it
/// together. Meshes named in them are `seg.off` beside the file.

#include <string>

namespace thenar::sample {

/// A wedge that bounds a solid, in a file's unit.
inline std::string wedge_off() {
  return "OFF\n4 4 0\n0 0 0\n20 0 0\n0 10 0\n0 0 5\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
}

/// Mimics of mimics, a slide that follows a hinge, frames of all kinds, unlike inertias.
inline std::string urdf_file() {
  return R"(<?xml version="1.0"?>
<robot name="claw">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="palm">
    <inertial><origin xyz="0.01 0 0.02" rpy="0.1 0.2 0.3"/><mass value="0.5"/>
      <inertia ixx="1e-3" ixy="1e-5" ixz="0" iyy="1.5e-3" iyz="0" izz="2e-3"/></inertial>
    <visual><geometry><mesh filename="package://claw/seg.off" scale="0.001 0.001 0.001"/></geometry>
      <material name="grey"/></visual>
    <collision><origin xyz="0 0 -0.02" rpy="0 1.1 0"/><geometry><box size="0.06 0.08 0.02"/>
      </geometry></collision>
    <collision><geometry><cylinder radius="0.01" length="0.05"/></geometry></collision>
  </link>
  <link name="mid"><collision><origin xyz="0.02 0 0"/><geometry>
    <mesh filename="seg.off" scale="0.001 0.001 0.002"/></geometry></collision></link>
  <link name="tip"><collision><geometry><sphere radius="0.008"/></geometry></collision></link>
  <link name="rod"/><link name="wheel"/><link name="mount"/>
  <joint name="curl" type="revolute"><origin xyz="0.03 0.01 0.02" rpy="1.2 -0.3 2"/>
    <parent link="palm"/><child link="mid"/><axis xyz="0.6 0 0.8"/>
    <limit lower="-0.2" upper="1.4" effort="3" velocity="2"/>
    <dynamics damping="0.1" friction="0.02"/></joint>
  <joint name="bend" type="revolute"><origin xyz="0.04 0 0" rpy="0 0 -0.7"/>
    <parent link="mid"/><child link="tip"/><axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" effort="3" velocity="2"/>
    <mimic joint="curl" multiplier="-0.8" offset="0.15"/></joint>
  <joint name="push" type="prismatic"><origin xyz="0 0 0.01" rpy="0.4 0 0"/>
    <parent link="palm"/><child link="rod"/><axis xyz="0 0 -2"/>
    <limit lower="-1" upper="1" effort="40" velocity="0.1"/>
    <mimic joint="bend" multiplier="0.02" offset="0.01"/></joint>
  <joint name="spin" type="continuous"><parent link="rod"/><child link="wheel"/></joint>
  <joint name="glue" type="fixed"><origin xyz="0 0 -0.1" rpy="0 0.5 0.25"/>
    <parent link="palm"/><child link="mount"/></joint>
  <transmission name="t"/><gazebo reference="mid"/>
</robot>
)";
}

/// Classes in classes, a frame, several joints on a body, every way to say how a body is turned,
/// references, an equality and a tendon, meshes that mirror.
inline std::string mjcf_file() {
  return R"(<mujoco model="claw">
  <compiler angle="degree" eulerseq="XYz" autolimits="true"/>
  <default>
    <joint damping="0.05"/>
    <geom type="capsule" size="0.01 0.02"/>
    <default class="finger"><joint axis="0 1 0" range="-10 80"/>
      <default class="tip"><joint range="0 70" ref="20"/><geom type="sphere" size="0.012"/></default>
    </default>
    <default class="seen"><geom type="mesh" contype="0" conaffinity="0" group="2"/></default>
  </default>
  <asset><mesh name="wedge" file="seg.off" scale="0.001 -0.001 0.001"/><texture name="t"/></asset>
  <worldbody>
    <light pos="0 0 1"/>
    <body name="palm" pos="0.1 0 0.2" euler="10 20 30" childclass="finger">
      <inertial pos="0 0 0.01" mass="0.4" fullinertia="1e-3 2e-3 2.5e-3 1e-5 0 2e-5"/>
      <geom type="box" size="0.03 0.04 0.01"/>
      <geom class="seen" mesh="wedge"/>
      <site name="s"/>
      <frame pos="0.02 0 0" axisangle="0 0 1 35">
        <body name="one" pos="0 0.03 0" quat="0.9 0.1 -0.2 0.3">
          <joint name="spread" axis="0 0 1" range="-20 20" pos="0 0 0.005"/>
          <joint name="curl"/>
          <geom fromto="0 0 0 0 0 0.04" size="0.008"/>
          <body name="two" pos="0 0 0.04" xyaxes="1 0.1 0 0 1 0.2">
            <joint name="bend" class="tip"/><geom class="tip"/>
          </body>
        </body>
      </frame>
      <body name="jaw" pos="0 -0.03 0" zaxis="1 2 3">
        <joint name="slide" type="slide" axis="1 1 0" range="-0.01 0.03"/>
        <geom type="mesh" mesh="wedge"/>
      </body>
      <body name="twin" pos="0 -0.05 0">
        <joint name="left" range="0 60"/><geom/>
        <body name="twin end" pos="0 0 0.05"><joint name="right" range="0 60"/><geom/></body>
      </body>
    </body>
  </worldbody>
  <tendon><fixed name="pull"><joint joint="left" coef="0.01"/><joint joint="right" coef="0.005"/>
    </fixed></tendon>
  <equality><joint joint1="bend" joint2="curl" polycoef="0.1 0.7 0 0 0"/></equality>
  <actuator>
    <position name="A1" joint="curl" kp="2" forcerange="-2 3"/>
    <motor name="A2" joint="slide" gear="10" ctrlrange="-1 1"/>
    <general name="A3" tendon="pull" forcerange="0 20"/>
  </actuator>
  <contact><exclude body1="palm" body2="one"/></contact>
</mujoco>
)";
}

/// A slide and two chains; couplings with offsets, a clutch and a spring; its bodies are
/// graspit_body_file() as `seg.xml`.
inline std::string graspit_file() {
  return R"(<?xml version="1.0" ?>
<robot type="Claw">
  <palm>seg.xml</palm>
  <dof type="r"><defaultVelocity>0</defaultVelocity><maxEffort>5e9</maxEffort></dof>
  <dof type="b"><defaultVelocity>1</defaultVelocity><maxEffort>5e9</maxEffort>
    <breakAwayTorque>5e8</breakAwayTorque><draggerScale>20</draggerScale></dof>
  <dof type="c"><defaultVelocity>-1</defaultVelocity><maxEffort>2e6</maxEffort></dof>
  <chain>
    <transform><translation>10 20 30</translation><rotation>40 x</rotation>
      <rotation>-90 z</rotation></transform>
    <joint type="Revolute"><theta>d0+15</theta><d>5</d><a>20</a><alpha>90</alpha>
      <minValue>-30</minValue><maxValue>60</maxValue></joint>
    <joint type="Revolute"><theta>d1*-1+40</theta><d>0</d><a>50</a><alpha>0</alpha>
      <minValue>-120</minValue><maxValue>0</maxValue><viscousFriction>5e7</viscousFriction></joint>
    <joint type="Revolute"><theta>d1*0.3333</theta><d>0</d><a>30</a><alpha>-30</alpha>
      <minValue>0</minValue><maxValue>40</maxValue></joint>
    <link dynamicJointType="Universal">seg.xml</link>
    <link dynamicJointType="Revolute">seg.xml</link>
  </chain>
  <chain>
    <transform><fullTransform>(0.6 0 0.8 0)[0 -20 0]</fullTransform></transform>
    <joint type="Prismatic"><theta>25</theta><d>d2*2+3</d><a>4</a><alpha>10</alpha>
      <minValue>0</minValue><maxValue>50</maxValue></joint>
    <link dynamicJointType="Prismatic">seg.xml</link>
    <link dynamicJointType="Fixed">seg.xml</link>
  </chain>
  <approachDirection><referenceLocation>0 0 20</referenceLocation><direction>0 0 1</direction>
  </approachDirection>
  <eigenGrasps>claw.xml</eigenGrasps>
</robot>
)";
}

inline std::string graspit_body_file() {
  return "<?xml version=\"1.0\" ?>\n<root>\n<material>plastic</material><mass>50</mass>\n"
         "<cog>5 2 1</cog><inertia_matrix>100 0 0 0 200 0 0 0 250</inertia_matrix>\n"
         "<geometryFile type=\"off\">seg.off</geometryFile>\n</root>\n";
}

}  // namespace thenar::sample
