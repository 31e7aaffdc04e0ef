/// A platform on six legs that lengthen and shorten together, and swing apart.
///
/// The fields are its parameters, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// [
///     mass_matrix, transpose(constraint_jacobian);
///     constraint_jacobian, 0
/// ] * [accelerations; multipliers] = [
///     generalized_forces - convective_forces;
///     -constraint_convective
/// ]
/// coordinates = [
///     platform_x;
///     platform_y;
///     platform_z;
///     platform_q0;
///     platform_q1;
///     platform_q2;
///     platform_q3
/// ]
/// multipliers = [
///     lambda_platform_norm;
///     lambda_a1_leg;
///     lambda_a2_leg;
///     lambda_b1_leg;
///     lambda_b2_leg;
///     lambda_c1_leg;
///     lambda_c2_leg
/// ]
/// constraints = 0
///
/// mass_matrix = [
///     m, 0, 0, 0, 0, 0, 0;
///     0, m, 0, 0, 0, 0, 0;
///     0, 0, m, 0, 0, 0, 0;
///     0, 0, 0, mass_matrix[4, 4], mass_matrix[4, 5], mass_matrix[4, 6], mass_matrix[4, 7];
///     0, 0, 0, mass_matrix[4, 5], mass_matrix[5, 5], mass_matrix[5, 6], mass_matrix[5, 7];
///     0, 0, 0, mass_matrix[4, 6], mass_matrix[5, 6], mass_matrix[6, 6], mass_matrix[6, 7];
///     0, 0, 0, mass_matrix[4, 7], mass_matrix[5, 7], mass_matrix[6, 7], mass_matrix[7, 7]
/// ]
/// mass_matrix[4, 4] = 4*platform_q1^2*A/s_1^2 + 4*platform_q2^2*A/s_1^2 + 4*platform_q3^2*C/s_1^2
///     + 4*platform_q0^2*(2*A + C)/3
/// mass_matrix[4, 5] = 4*s_36 - 4*s_35 - 4*platform_q2*platform_q3*C/s_1^2
///     + 4*platform_q0*platform_q1*(2*A + C)/3
/// mass_matrix[4, 6] = 4*platform_q1*platform_q3*C/s_1^2 - 4*s_37 - 4*s_38
///     + 4*platform_q0*platform_q2*(2*A + C)/3
/// mass_matrix[4, 7] = 4*platform_q0*platform_q3*(2*A + C)/3 - 4*platform_q0*platform_q3*C/s_1^2
/// mass_matrix[5, 5] = 4*platform_q0^2*A/s_1^2 + 4*platform_q3^2*A/s_1^2 + 4*platform_q2^2*C/s_1^2
///     + 4*platform_q1^2*(2*A + C)/3
/// mass_matrix[5, 6] = 4*platform_q1*platform_q2*(2*A + C)/3 - 4*platform_q1*platform_q2*C/s_1^2
/// mass_matrix[5, 7] = 4*platform_q0*platform_q2*C/s_1^2 - 4*s_37 - 4*s_38
///     + 4*platform_q1*platform_q3*(2*A + C)/3
/// mass_matrix[6, 6] = 4*platform_q0^2*A/s_1^2 + 4*platform_q3^2*A/s_1^2 + 4*platform_q1^2*C/s_1^2
///     + 4*platform_q2^2*(2*A + C)/3
/// mass_matrix[6, 7] = 4*s_35 - 4*s_36 - 4*platform_q0*platform_q1*C/s_1^2
///     + 4*platform_q2*platform_q3*(2*A + C)/3
/// mass_matrix[7, 7] = 4*platform_q1^2*A/s_1^2 + 4*platform_q2^2*A/s_1^2 + 4*platform_q0^2*C/s_1^2
///     + 4*platform_q3^2*(2*A + C)/3
///
/// convective_forces = [
///     0;
///     0;
///     0;
///     convective_forces[4];
///     convective_forces[5];
///     convective_forces[6];
///     convective_forces[7]
/// ]
/// convective_forces[4] = 8*platform_q3*C*s_10*s_11/s_1^3 - 8*platform_q1*s_33/s_1 - 8*platform_q2*s_34/s_1
///     + 4*platform_q0*s_32*(2*A + C)/3
/// convective_forces[5] = 8*platform_q0*s_33/s_1 - 8*platform_q3*s_34/s_1 - 8*platform_q2*C*s_10*s_11/s_1^3
///     + 4*platform_q1*s_32*(2*A + C)/3
/// convective_forces[6] = 8*platform_q3*s_33/s_1 + 8*platform_q0*s_34/s_1 + 8*platform_q1*C*s_10*s_11/s_1^3
///     + 4*platform_q2*s_32*(2*A + C)/3
/// convective_forces[7] = 8*platform_q1*s_34/s_1 - 8*platform_q2*s_33/s_1 - 8*platform_q0*C*s_10*s_11/s_1^3
///     + 4*platform_q3*s_32*(2*A + C)/3
///
/// generalized_forces = [0; 0; -m*g; 0; 0; 0; 0]
///
/// constraints = [
///     constraints[1];
///     constraints[2];
///     constraints[3];
///     constraints[4];
///     constraints[5];
///     constraints[6];
///     constraints[7]
/// ]
/// constraints[1] = platform_q0^2 + platform_q1^2 + platform_q2^2 + platform_q3^2 - 1
/// constraints[2] = sqrt(s_14) - L - heave*sin(t*w) - sway*sin(t*w)
/// constraints[3] = sqrt(s_17) - L - heave*sin(t*w) + s_18
/// constraints[4] = sqrt(s_21) - L - heave*sin(t*w) - s_18
/// constraints[5] = sqrt(s_24) - L - heave*sin(t*w) + s_25
/// constraints[6] = sqrt(s_28) - L - heave*sin(t*w) - s_25
/// constraints[7] = sqrt(s_31) - L - heave*sin(t*w) + sway*sin(2*pi + t*w)
///
/// constraint_jacobian = [
///     0, 0, 0, constraint_jacobian[1, 4], constraint_jacobian[1, 5], constraint_jacobian[1, 6], constraint_jacobian[1, 7];
///     s_12*sqrt(s_14)/s_14, s_13*sqrt(s_14)/s_14, constraint_jacobian[2, 3], constraint_jacobian[2, 4], constraint_jacobian[2, 5], constraint_jacobian[2, 6], constraint_jacobian[2, 7];
///     s_15*sqrt(s_17)/s_17, s_16*sqrt(s_17)/s_17, constraint_jacobian[3, 3], constraint_jacobian[3, 4], constraint_jacobian[3, 5], constraint_jacobian[3, 6], constraint_jacobian[3, 7];
///     s_19*sqrt(s_21)/s_21, s_20*sqrt(s_21)/s_21, constraint_jacobian[4, 3], constraint_jacobian[4, 4], constraint_jacobian[4, 5], constraint_jacobian[4, 6], constraint_jacobian[4, 7];
///     s_22*sqrt(s_24)/s_24, s_23*sqrt(s_24)/s_24, constraint_jacobian[5, 3], constraint_jacobian[5, 4], constraint_jacobian[5, 5], constraint_jacobian[5, 6], constraint_jacobian[5, 7];
///     s_26*sqrt(s_28)/s_28, s_27*sqrt(s_28)/s_28, constraint_jacobian[6, 3], constraint_jacobian[6, 4], constraint_jacobian[6, 5], constraint_jacobian[6, 6], constraint_jacobian[6, 7];
///     s_29*sqrt(s_31)/s_31, s_30*sqrt(s_31)/s_31, constraint_jacobian[7, 3], constraint_jacobian[7, 4], constraint_jacobian[7, 5], constraint_jacobian[7, 6], constraint_jacobian[7, 7]
/// ]
/// constraint_jacobian[1, 4] = 2*platform_q0
/// constraint_jacobian[1, 5] = 2*platform_q1
/// constraint_jacobian[1, 6] = 2*platform_q2
/// constraint_jacobian[1, 7] = 2*platform_q3
/// constraint_jacobian[2, 3] = a1_on_platform_z*sqrt(s_14)/s_14
/// constraint_jacobian[2, 4] = 2*s_46*sqrt(s_14)/s_14
/// constraint_jacobian[2, 5] = 2*s_53*sqrt(s_14)/s_14
/// constraint_jacobian[2, 6] = 2*s_60*sqrt(s_14)/s_14
/// constraint_jacobian[2, 7] = -2*s_66*sqrt(s_14)/s_14
/// constraint_jacobian[3, 3] = a2_on_platform_z*sqrt(s_17)/s_17
/// constraint_jacobian[3, 4] = 2*s_120*sqrt(s_17)/s_17
/// constraint_jacobian[3, 5] = 2*s_126*sqrt(s_17)/s_17
/// constraint_jacobian[3, 6] = 2*s_132*sqrt(s_17)/s_17
/// constraint_jacobian[3, 7] = -2*s_136*sqrt(s_17)/s_17
/// constraint_jacobian[4, 3] = b1_on_platform_z*sqrt(s_21)/s_21
/// constraint_jacobian[4, 4] = 2*s_181*sqrt(s_21)/s_21
/// constraint_jacobian[4, 5] = 2*s_187*sqrt(s_21)/s_21
/// constraint_jacobian[4, 6] = 2*s_193*sqrt(s_21)/s_21
/// constraint_jacobian[4, 7] = -2*s_197*sqrt(s_21)/s_21
/// constraint_jacobian[5, 3] = b2_on_platform_z*sqrt(s_24)/s_24
/// constraint_jacobian[5, 4] = 2*s_241*sqrt(s_24)/s_24
/// constraint_jacobian[5, 5] = 2*s_247*sqrt(s_24)/s_24
/// constraint_jacobian[5, 6] = 2*s_253*sqrt(s_24)/s_24
/// constraint_jacobian[5, 7] = -2*s_257*sqrt(s_24)/s_24
/// constraint_jacobian[6, 3] = c1_on_platform_z*sqrt(s_28)/s_28
/// constraint_jacobian[6, 4] = 2*s_302*sqrt(s_28)/s_28
/// constraint_jacobian[6, 5] = 2*s_308*sqrt(s_28)/s_28
/// constraint_jacobian[6, 6] = 2*s_314*sqrt(s_28)/s_28
/// constraint_jacobian[6, 7] = -2*s_318*sqrt(s_28)/s_28
/// constraint_jacobian[7, 3] = c2_on_platform_z*sqrt(s_31)/s_31
/// constraint_jacobian[7, 4] = 2*s_362*sqrt(s_31)/s_31
/// constraint_jacobian[7, 5] = 2*s_368*sqrt(s_31)/s_31
/// constraint_jacobian[7, 6] = 2*s_374*sqrt(s_31)/s_31
/// constraint_jacobian[7, 7] = -2*s_378*sqrt(s_31)/s_31
///
/// constraint_convective = [
///     constraint_convective[1];
///     constraint_convective[2];
///     constraint_convective[3];
///     constraint_convective[4];
///     constraint_convective[5];
///     constraint_convective[6];
///     constraint_convective[7]
/// ]
/// constraint_convective[1] = 2*platform_q0_dot^2 + 2*platform_q1_dot^2 + 2*platform_q2_dot^2 + 2*platform_q3_dot^2
/// constraint_convective[2] = heave*w^2*sin(t*w) + sway*w^2*sin(t*w) + s_69*platform_x_dot*sqrt(s_14)/s_14
///     - s_12*s_76*platform_x_dot*sqrt(s_14)/s_14^2 + s_72*platform_y_dot*sqrt(s_14)/s_14
///     - s_13*s_76*platform_y_dot*sqrt(s_14)/s_14^2 + s_75*platform_z_dot*sqrt(s_14)/s_14
///     - a1_on_platform_z*s_76*platform_z_dot*sqrt(s_14)/s_14^2
///     - 2*s_46*s_76*platform_q0_dot*sqrt(s_14)/s_14^2 + 2*s_88*platform_q0_dot*sqrt(s_14)/s_14
///     - 2*s_53*s_76*platform_q1_dot*sqrt(s_14)/s_14^2 + 2*s_97*platform_q1_dot*sqrt(s_14)/s_14
///     - 2*s_60*s_76*platform_q2_dot*sqrt(s_14)/s_14^2 + 2*s_106*platform_q2_dot*sqrt(s_14)/s_14
///     + 2*s_66*s_76*platform_q3_dot*sqrt(s_14)/s_14^2 - 2*s_112*platform_q3_dot*sqrt(s_14)/s_14
/// constraint_convective[3] = heave*w^2*sin(t*w) - s_137 + s_138*platform_x_dot*sqrt(s_17)/s_17
///     - s_15*s_141*platform_x_dot*sqrt(s_17)/s_17^2 + s_139*platform_y_dot*sqrt(s_17)/s_17
///     - s_16*s_141*platform_y_dot*sqrt(s_17)/s_17^2 + s_140*platform_z_dot*sqrt(s_17)/s_17
///     - a2_on_platform_z*s_141*platform_z_dot*sqrt(s_17)/s_17^2
///     - 2*s_120*s_141*platform_q0_dot*sqrt(s_17)/s_17^2
///     + 2*s_153*platform_q0_dot*sqrt(s_17)/s_17
///     - 2*s_126*s_141*platform_q1_dot*sqrt(s_17)/s_17^2
///     + 2*s_161*platform_q1_dot*sqrt(s_17)/s_17
///     - 2*s_132*s_141*platform_q2_dot*sqrt(s_17)/s_17^2
///     + 2*s_169*platform_q2_dot*sqrt(s_17)/s_17
///     + 2*s_136*s_141*platform_q3_dot*sqrt(s_17)/s_17^2
///     - 2*s_173*platform_q3_dot*sqrt(s_17)/s_17
/// constraint_convective[4] = heave*w^2*sin(t*w) + s_137 + s_198*platform_x_dot*sqrt(s_21)/s_21
///     - s_19*s_201*platform_x_dot*sqrt(s_21)/s_21^2 + s_199*platform_y_dot*sqrt(s_21)/s_21
///     - s_20*s_201*platform_y_dot*sqrt(s_21)/s_21^2 + s_200*platform_z_dot*sqrt(s_21)/s_21
///     - b1_on_platform_z*s_201*platform_z_dot*sqrt(s_21)/s_21^2
///     - 2*s_181*s_201*platform_q0_dot*sqrt(s_21)/s_21^2
///     + 2*s_213*platform_q0_dot*sqrt(s_21)/s_21
///     - 2*s_187*s_201*platform_q1_dot*sqrt(s_21)/s_21^2
///     + 2*s_221*platform_q1_dot*sqrt(s_21)/s_21
///     - 2*s_193*s_201*platform_q2_dot*sqrt(s_21)/s_21^2
///     + 2*s_229*platform_q2_dot*sqrt(s_21)/s_21
///     + 2*s_197*s_201*platform_q3_dot*sqrt(s_21)/s_21^2
///     - 2*s_233*platform_q3_dot*sqrt(s_21)/s_21
/// constraint_convective[5] = heave*w^2*sin(t*w) - s_258 + s_259*platform_x_dot*sqrt(s_24)/s_24
///     - s_22*s_262*platform_x_dot*sqrt(s_24)/s_24^2 + s_260*platform_y_dot*sqrt(s_24)/s_24
///     - s_23*s_262*platform_y_dot*sqrt(s_24)/s_24^2 + s_261*platform_z_dot*sqrt(s_24)/s_24
///     - b2_on_platform_z*s_262*platform_z_dot*sqrt(s_24)/s_24^2
///     - 2*s_241*s_262*platform_q0_dot*sqrt(s_24)/s_24^2
///     + 2*s_274*platform_q0_dot*sqrt(s_24)/s_24
///     - 2*s_247*s_262*platform_q1_dot*sqrt(s_24)/s_24^2
///     + 2*s_282*platform_q1_dot*sqrt(s_24)/s_24
///     - 2*s_253*s_262*platform_q2_dot*sqrt(s_24)/s_24^2
///     + 2*s_290*platform_q2_dot*sqrt(s_24)/s_24
///     + 2*s_257*s_262*platform_q3_dot*sqrt(s_24)/s_24^2
///     - 2*s_294*platform_q3_dot*sqrt(s_24)/s_24
/// constraint_convective[6] = heave*w^2*sin(t*w) + s_258 + s_319*platform_x_dot*sqrt(s_28)/s_28
///     - s_26*s_322*platform_x_dot*sqrt(s_28)/s_28^2 + s_320*platform_y_dot*sqrt(s_28)/s_28
///     - s_27*s_322*platform_y_dot*sqrt(s_28)/s_28^2 + s_321*platform_z_dot*sqrt(s_28)/s_28
///     - c1_on_platform_z*s_322*platform_z_dot*sqrt(s_28)/s_28^2
///     - 2*s_302*s_322*platform_q0_dot*sqrt(s_28)/s_28^2
///     + 2*s_334*platform_q0_dot*sqrt(s_28)/s_28
///     - 2*s_308*s_322*platform_q1_dot*sqrt(s_28)/s_28^2
///     + 2*s_342*platform_q1_dot*sqrt(s_28)/s_28
///     - 2*s_314*s_322*platform_q2_dot*sqrt(s_28)/s_28^2
///     + 2*s_350*platform_q2_dot*sqrt(s_28)/s_28
///     + 2*s_318*s_322*platform_q3_dot*sqrt(s_28)/s_28^2
///     - 2*s_354*platform_q3_dot*sqrt(s_28)/s_28
/// constraint_convective[7] = heave*w^2*sin(t*w) - sway*w^2*sin(2*pi + t*w) + s_379*platform_x_dot*sqrt(s_31)/s_31
///     - s_29*s_382*platform_x_dot*sqrt(s_31)/s_31^2 + s_380*platform_y_dot*sqrt(s_31)/s_31
///     - s_30*s_382*platform_y_dot*sqrt(s_31)/s_31^2 + s_381*platform_z_dot*sqrt(s_31)/s_31
///     - c2_on_platform_z*s_382*platform_z_dot*sqrt(s_31)/s_31^2
///     - 2*s_362*s_382*platform_q0_dot*sqrt(s_31)/s_31^2
///     + 2*s_394*platform_q0_dot*sqrt(s_31)/s_31
///     - 2*s_368*s_382*platform_q1_dot*sqrt(s_31)/s_31^2
///     + 2*s_402*platform_q1_dot*sqrt(s_31)/s_31
///     - 2*s_374*s_382*platform_q2_dot*sqrt(s_31)/s_31^2
///     + 2*s_410*platform_q2_dot*sqrt(s_31)/s_31
///     + 2*s_378*s_382*platform_q3_dot*sqrt(s_31)/s_31^2
///     - 2*s_414*platform_q3_dot*sqrt(s_31)/s_31
///
/// a1_head_angle = pi/3 - head
/// a1_on_ground_x = R*cos(foot)
/// a1_on_ground_y = R*sin(foot)
/// s_1 = platform_q0^2 + platform_q1^2 + platform_q2^2 + platform_q3^2
/// s_2 = platform_q2^2 + platform_q3^2
/// s_3 = platform_q1*platform_q2 - platform_q0*platform_q3
/// s_4 = platform_q1*platform_q2 + platform_q0*platform_q3
/// s_5 = platform_q1^2 + platform_q3^2
/// s_6 = platform_q1*platform_q3 - platform_q0*platform_q2
/// s_7 = platform_q2*platform_q3 + platform_q0*platform_q1
/// s_8 = platform_q0*platform_q1_dot - platform_q1*platform_q0_dot - platform_q2*platform_q3_dot
///     + platform_q3*platform_q2_dot
/// s_9 = platform_q0*platform_q2_dot - platform_q2*platform_q0_dot - platform_q3*platform_q1_dot
///     + platform_q1*platform_q3_dot
/// s_10 = platform_q0*platform_q3_dot - platform_q3*platform_q0_dot - platform_q1*platform_q2_dot
///     + platform_q2*platform_q1_dot
/// s_11 = platform_q0*platform_q0_dot + platform_q1*platform_q1_dot + platform_q2*platform_q2_dot
///     + platform_q3*platform_q3_dot
/// a1_on_platform_z = platform_z + 2*r*s_6*cos(a1_head_angle)/s_1 + 2*r*s_7*sin(a1_head_angle)/s_1
/// a2_foot_angle = 2*pi/3 - foot
/// a2_head_angle = pi/3 + head
/// a2_on_ground_x = R*cos(a2_foot_angle)
/// a2_on_ground_y = R*sin(a2_foot_angle)
/// a2_on_platform_z = platform_z + 2*r*s_6*cos(a2_head_angle)/s_1 + 2*r*s_7*sin(a2_head_angle)/s_1
/// b1_foot_angle = 2*pi/3 + foot
/// b1_head_angle = pi - head
/// b1_on_ground_x = R*cos(b1_foot_angle)
/// b1_on_ground_y = R*sin(b1_foot_angle)
/// b1_on_platform_z = platform_z + 2*r*s_6*cos(b1_head_angle)/s_1 + 2*r*s_7*sin(b1_head_angle)/s_1
/// b2_foot_angle = 4*pi/3 - foot
/// b2_head_angle = pi + head
/// b2_on_ground_x = R*cos(b2_foot_angle)
/// b2_on_ground_y = R*sin(b2_foot_angle)
/// b2_on_platform_z = platform_z + 2*r*s_6*cos(b2_head_angle)/s_1 + 2*r*s_7*sin(b2_head_angle)/s_1
/// c1_foot_angle = 4*pi/3 + foot
/// c1_head_angle = 5*pi/3 - head
/// c1_on_ground_x = R*cos(c1_foot_angle)
/// c1_on_ground_y = R*sin(c1_foot_angle)
/// c1_on_platform_z = platform_z + 2*r*s_6*cos(c1_head_angle)/s_1 + 2*r*s_7*sin(c1_head_angle)/s_1
/// c2_foot_angle = 2*pi - foot
/// c2_head_angle = 5*pi/3 + head
/// c2_on_ground_x = R*cos(c2_foot_angle)
/// c2_on_ground_y = R*sin(c2_foot_angle)
/// c2_on_platform_z = platform_z + 2*r*s_6*cos(c2_head_angle)/s_1 + 2*r*s_7*sin(c2_head_angle)/s_1
/// s_12 = platform_x - a1_on_ground_x - r*(2*s_2/s_1 - 1)*cos(a1_head_angle)
///     + 2*r*s_3*sin(a1_head_angle)/s_1
/// s_13 = platform_y - a1_on_ground_y + 2*r*s_4*cos(a1_head_angle)/s_1
///     - r*(2*s_5/s_1 - 1)*sin(a1_head_angle)
/// s_14 = s_12^2 + s_13^2 + a1_on_platform_z^2
/// s_15 = platform_x - a2_on_ground_x - r*(2*s_2/s_1 - 1)*cos(a2_head_angle)
///     + 2*r*s_3*sin(a2_head_angle)/s_1
/// s_16 = platform_y - a2_on_ground_y + 2*r*s_4*cos(a2_head_angle)/s_1
///     - r*(2*s_5/s_1 - 1)*sin(a2_head_angle)
/// s_17 = s_15^2 + s_16^2 + a2_on_platform_z^2
/// s_18 = sway*sin(2*pi/3 + t*w)
/// s_19 = platform_x - b1_on_ground_x - r*(2*s_2/s_1 - 1)*cos(b1_head_angle)
///     + 2*r*s_3*sin(b1_head_angle)/s_1
/// s_20 = platform_y - b1_on_ground_y + 2*r*s_4*cos(b1_head_angle)/s_1
///     - r*(2*s_5/s_1 - 1)*sin(b1_head_angle)
/// s_21 = s_19^2 + s_20^2 + b1_on_platform_z^2
/// s_22 = platform_x - b2_on_ground_x - r*(2*s_2/s_1 - 1)*cos(b2_head_angle)
///     + 2*r*s_3*sin(b2_head_angle)/s_1
/// s_23 = platform_y - b2_on_ground_y + 2*r*s_4*cos(b2_head_angle)/s_1
///     - r*(2*s_5/s_1 - 1)*sin(b2_head_angle)
/// s_24 = s_22^2 + s_23^2 + b2_on_platform_z^2
/// s_25 = sway*sin(4*pi/3 + t*w)
/// s_26 = platform_x - c1_on_ground_x - r*(2*s_2/s_1 - 1)*cos(c1_head_angle)
///     + 2*r*s_3*sin(c1_head_angle)/s_1
/// s_27 = platform_y - c1_on_ground_y + 2*r*s_4*cos(c1_head_angle)/s_1
///     - r*(2*s_5/s_1 - 1)*sin(c1_head_angle)
/// s_28 = s_26^2 + s_27^2 + c1_on_platform_z^2
/// s_29 = platform_x - c2_on_ground_x - r*(2*s_2/s_1 - 1)*cos(c2_head_angle)
///     + 2*r*s_3*sin(c2_head_angle)/s_1
/// s_30 = platform_y - c2_on_ground_y + 2*r*s_4*cos(c2_head_angle)/s_1
///     - r*(2*s_5/s_1 - 1)*sin(c2_head_angle)
/// s_31 = s_29^2 + s_30^2 + c2_on_platform_z^2
/// s_32 = platform_q0_dot^2 + platform_q1_dot^2 + platform_q2_dot^2 + platform_q3_dot^2
/// s_33 = C*s_9*s_10/s_1^2 - A*s_9*s_10/s_1^2 - A*s_8*s_11/s_1^2
/// s_34 = A*s_8*s_10/s_1^2 - C*s_8*s_10/s_1^2 - A*s_9*s_11/s_1^2
/// s_35 = platform_q0*platform_q1*A/s_1^2
/// s_36 = platform_q2*platform_q3*A/s_1^2
/// s_37 = platform_q1*platform_q3*A/s_1^2
/// s_38 = platform_q0*platform_q2*A/s_1^2
/// s_39 = platform_q3*r*sin(a1_head_angle)/s_1
/// s_40 = 2*platform_q0*r*s_2*cos(a1_head_angle)/s_1^2
///     - 2*platform_q0*r*s_3*sin(a1_head_angle)/s_1^2 - s_39
/// s_41 = platform_q3*r*cos(a1_head_angle)/s_1
/// s_42 = s_41 - 2*platform_q0*r*s_4*cos(a1_head_angle)/s_1^2
///     + 2*platform_q0*r*s_5*sin(a1_head_angle)/s_1^2
/// s_43 = platform_q2*r*cos(a1_head_angle)/s_1
/// s_44 = platform_q1*r*sin(a1_head_angle)/s_1
/// s_45 = 2*platform_q0*r*s_6*cos(a1_head_angle)/s_1^2 + s_43 - s_44
///     + 2*platform_q0*r*s_7*sin(a1_head_angle)/s_1^2
/// s_46 = s_12*s_40 + s_13*s_42 - a1_on_platform_z*s_45
/// s_47 = platform_q2*r*sin(a1_head_angle)/s_1
/// s_48 = 2*platform_q1*r*s_2*cos(a1_head_angle)/s_1^2 + s_47
///     - 2*platform_q1*r*s_3*sin(a1_head_angle)/s_1^2
/// s_49 = platform_q1/s_1 - platform_q1*s_5/s_1^2
/// s_50 = s_43 - 2*platform_q1*r*s_4*cos(a1_head_angle)/s_1^2 - 2*r*s_49*sin(a1_head_angle)
/// s_51 = platform_q0*r*sin(a1_head_angle)/s_1
/// s_52 = s_41 - 2*platform_q1*r*s_6*cos(a1_head_angle)/s_1^2 + s_51
///     - 2*platform_q1*r*s_7*sin(a1_head_angle)/s_1^2
/// s_53 = s_12*s_48 + s_13*s_50 + a1_on_platform_z*s_52
/// s_54 = platform_q2/s_1 - platform_q2*s_2/s_1^2
/// s_55 = s_44 - 2*r*s_54*cos(a1_head_angle) - 2*platform_q2*r*s_3*sin(a1_head_angle)/s_1^2
/// s_56 = platform_q1*r*cos(a1_head_angle)/s_1
/// s_57 = s_56 - 2*platform_q2*r*s_4*cos(a1_head_angle)/s_1^2
///     + 2*platform_q2*r*s_5*sin(a1_head_angle)/s_1^2
/// s_58 = platform_q0*r*cos(a1_head_angle)/s_1
/// s_59 = s_39 - 2*platform_q2*r*s_6*cos(a1_head_angle)/s_1^2 - s_58
///     - 2*platform_q2*r*s_7*sin(a1_head_angle)/s_1^2
/// s_60 = s_12*s_55 + s_13*s_57 + a1_on_platform_z*s_59
/// s_61 = platform_q3/s_1 - platform_q3*s_2/s_1^2
/// s_62 = s_51 + 2*r*s_61*cos(a1_head_angle) + 2*platform_q3*r*s_3*sin(a1_head_angle)/s_1^2
/// s_63 = platform_q3/s_1 - platform_q3*s_5/s_1^2
/// s_64 = s_58 - 2*platform_q3*r*s_4*cos(a1_head_angle)/s_1^2 - 2*r*s_63*sin(a1_head_angle)
/// s_65 = s_47 + s_56 - 2*platform_q3*r*s_6*cos(a1_head_angle)/s_1^2
///     - 2*platform_q3*r*s_7*sin(a1_head_angle)/s_1^2
/// s_66 = s_12*s_62 - s_13*s_64 - a1_on_platform_z*s_65
/// s_67 = platform_q2*platform_q2_dot + platform_q3*platform_q3_dot
/// s_68 = platform_q0*platform_q3_dot + platform_q3*platform_q0_dot - platform_q1*platform_q2_dot
///     - platform_q2*platform_q1_dot
/// s_69 = platform_x_dot + 4*r*(s_2*s_11/s_1^2 - s_67/s_1)*cos(a1_head_angle)
///     - 4*r*s_3*s_11*sin(a1_head_angle)/s_1^2 - 2*r*s_68*sin(a1_head_angle)/s_1
/// s_70 = platform_q0*platform_q3_dot + platform_q3*platform_q0_dot + platform_q1*platform_q2_dot
///     + platform_q2*platform_q1_dot
/// s_71 = platform_q1*platform_q1_dot + platform_q3*platform_q3_dot
/// s_72 = platform_y_dot + 2*r*s_70*cos(a1_head_angle)/s_1
///     - 4*r*s_4*s_11*cos(a1_head_angle)/s_1^2
///     + 4*r*(s_5*s_11/s_1^2 - s_71/s_1)*sin(a1_head_angle)
/// s_73 = platform_q0*platform_q2_dot + platform_q2*platform_q0_dot - platform_q3*platform_q1_dot
///     - platform_q1*platform_q3_dot
/// s_74 = platform_q0*platform_q1_dot + platform_q1*platform_q0_dot + platform_q2*platform_q3_dot
///     + platform_q3*platform_q2_dot
/// s_75 = platform_z_dot - 4*r*s_6*s_11*cos(a1_head_angle)/s_1^2
///     - 2*r*s_73*cos(a1_head_angle)/s_1 + 2*r*s_74*sin(a1_head_angle)/s_1
///     - 4*r*s_7*s_11*sin(a1_head_angle)/s_1^2
/// s_76 = s_12*s_69 + s_13*s_72 + a1_on_platform_z*s_75
/// s_77 = r*platform_q3_dot*sin(a1_head_angle)/s_1
/// s_78 = platform_q3*r*s_11*sin(a1_head_angle)/s_1^2
/// s_79 = 2*r*s_2*platform_q0_dot*cos(a1_head_angle)/s_1^2
///     - 8*platform_q0*r*s_2*s_11*cos(a1_head_angle)/s_1^3
///     + 4*platform_q0*r*s_67*cos(a1_head_angle)/s_1^2
///     - 2*r*s_3*platform_q0_dot*sin(a1_head_angle)/s_1^2
///     + 8*platform_q0*r*s_3*s_11*sin(a1_head_angle)/s_1^3
///     + 2*platform_q0*r*s_68*sin(a1_head_angle)/s_1^2 - s_77 + 2*s_78
/// s_80 = r*platform_q3_dot*cos(a1_head_angle)/s_1
/// s_81 = platform_q3*r*s_11*cos(a1_head_angle)/s_1^2
/// s_82 = s_80 - 2*s_81 - 2*r*s_4*platform_q0_dot*cos(a1_head_angle)/s_1^2
///     - 2*platform_q0*r*s_70*cos(a1_head_angle)/s_1^2
///     + 8*platform_q0*r*s_4*s_11*cos(a1_head_angle)/s_1^3
///     + 2*r*s_5*platform_q0_dot*sin(a1_head_angle)/s_1^2
///     - 8*platform_q0*r*s_5*s_11*sin(a1_head_angle)/s_1^3
///     + 4*platform_q0*r*s_71*sin(a1_head_angle)/s_1^2
/// s_83 = r*platform_q2_dot*cos(a1_head_angle)/s_1
/// s_84 = platform_q2*r*s_11*cos(a1_head_angle)/s_1^2
/// s_85 = r*platform_q1_dot*sin(a1_head_angle)/s_1
/// s_86 = platform_q1*r*s_11*sin(a1_head_angle)/s_1^2
/// s_87 = 2*r*s_6*platform_q0_dot*cos(a1_head_angle)/s_1^2
///     - 8*platform_q0*r*s_6*s_11*cos(a1_head_angle)/s_1^3
///     - 2*platform_q0*r*s_73*cos(a1_head_angle)/s_1^2 + s_83 - 2*s_84 - s_85 + 2*s_86
///     + 2*r*s_7*platform_q0_dot*sin(a1_head_angle)/s_1^2
///     + 2*platform_q0*r*s_74*sin(a1_head_angle)/s_1^2
///     - 8*platform_q0*r*s_7*s_11*sin(a1_head_angle)/s_1^3
/// s_88 = s_40*s_69 + s_12*s_79 + s_42*s_72 + s_13*s_82 - s_45*s_75 - a1_on_platform_z*s_87
/// s_89 = r*platform_q2_dot*sin(a1_head_angle)/s_1
/// s_90 = platform_q2*r*s_11*sin(a1_head_angle)/s_1^2
/// s_91 = 2*r*s_2*platform_q1_dot*cos(a1_head_angle)/s_1^2
///     - 8*platform_q1*r*s_2*s_11*cos(a1_head_angle)/s_1^3
///     + 4*platform_q1*r*s_67*cos(a1_head_angle)/s_1^2 + s_89 - 2*s_90
///     - 2*r*s_3*platform_q1_dot*sin(a1_head_angle)/s_1^2
///     + 8*platform_q1*r*s_3*s_11*sin(a1_head_angle)/s_1^3
///     + 2*platform_q1*r*s_68*sin(a1_head_angle)/s_1^2
/// s_92 = platform_q1_dot/s_1 - 2*platform_q1*s_11/s_1^2 - s_5*platform_q1_dot/s_1^2
///     + 4*platform_q1*s_5*s_11/s_1^3 - 2*platform_q1*s_71/s_1^2
/// s_93 = s_83 - 2*s_84 - 2*r*s_4*platform_q1_dot*cos(a1_head_angle)/s_1^2
///     - 2*platform_q1*r*s_70*cos(a1_head_angle)/s_1^2
///     + 8*platform_q1*r*s_4*s_11*cos(a1_head_angle)/s_1^3 - 2*r*s_92*sin(a1_head_angle)
/// s_94 = r*platform_q0_dot*sin(a1_head_angle)/s_1
/// s_95 = platform_q0*r*s_11*sin(a1_head_angle)/s_1^2
/// s_96 = s_80 - 2*s_81 - 2*r*s_6*platform_q1_dot*cos(a1_head_angle)/s_1^2
///     + 8*platform_q1*r*s_6*s_11*cos(a1_head_angle)/s_1^3
///     + 2*platform_q1*r*s_73*cos(a1_head_angle)/s_1^2 + s_94 - 2*s_95
///     - 2*r*s_7*platform_q1_dot*sin(a1_head_angle)/s_1^2
///     - 2*platform_q1*r*s_74*sin(a1_head_angle)/s_1^2
///     + 8*platform_q1*r*s_7*s_11*sin(a1_head_angle)/s_1^3
/// s_97 = s_48*s_69 + s_12*s_91 + s_50*s_72 + s_13*s_93 + s_52*s_75 + a1_on_platform_z*s_96
/// s_98 = platform_q2_dot/s_1 - 2*platform_q2*s_11/s_1^2 - s_2*platform_q2_dot/s_1^2
///     + 4*platform_q2*s_2*s_11/s_1^3 - 2*platform_q2*s_67/s_1^2
/// s_99 = s_85 - 2*s_86 - 2*r*s_98*cos(a1_head_angle)
///     - 2*r*s_3*platform_q2_dot*sin(a1_head_angle)/s_1^2
///     + 8*platform_q2*r*s_3*s_11*sin(a1_head_angle)/s_1^3
///     + 2*platform_q2*r*s_68*sin(a1_head_angle)/s_1^2
/// s_100 = r*platform_q1_dot*cos(a1_head_angle)/s_1
/// s_101 = platform_q1*r*s_11*cos(a1_head_angle)/s_1^2
/// s_102 = s_100 - 2*s_101 - 2*r*s_4*platform_q2_dot*cos(a1_head_angle)/s_1^2
///     - 2*platform_q2*r*s_70*cos(a1_head_angle)/s_1^2
///     + 8*platform_q2*r*s_4*s_11*cos(a1_head_angle)/s_1^3
///     + 2*r*s_5*platform_q2_dot*sin(a1_head_angle)/s_1^2
///     - 8*platform_q2*r*s_5*s_11*sin(a1_head_angle)/s_1^3
///     + 4*platform_q2*r*s_71*sin(a1_head_angle)/s_1^2
/// s_103 = r*platform_q0_dot*cos(a1_head_angle)/s_1
/// s_104 = platform_q0*r*s_11*cos(a1_head_angle)/s_1^2
/// s_105 = s_77 - 2*s_78 - 2*r*s_6*platform_q2_dot*cos(a1_head_angle)/s_1^2
///     + 8*platform_q2*r*s_6*s_11*cos(a1_head_angle)/s_1^3
///     + 2*platform_q2*r*s_73*cos(a1_head_angle)/s_1^2 - s_103 + 2*s_104
///     - 2*r*s_7*platform_q2_dot*sin(a1_head_angle)/s_1^2
///     - 2*platform_q2*r*s_74*sin(a1_head_angle)/s_1^2
///     + 8*platform_q2*r*s_7*s_11*sin(a1_head_angle)/s_1^3
/// s_106 = s_55*s_69 + s_12*s_99 + s_57*s_72 + s_13*s_102 + s_59*s_75 + a1_on_platform_z*s_105
/// s_107 = platform_q3_dot/s_1 - 2*platform_q3*s_11/s_1^2 - s_2*platform_q3_dot/s_1^2
///     + 4*platform_q3*s_2*s_11/s_1^3 - 2*platform_q3*s_67/s_1^2
/// s_108 = s_94 - 2*s_95 + 2*r*s_107*cos(a1_head_angle)
///     + 2*r*s_3*platform_q3_dot*sin(a1_head_angle)/s_1^2
///     - 8*platform_q3*r*s_3*s_11*sin(a1_head_angle)/s_1^3
///     - 2*platform_q3*r*s_68*sin(a1_head_angle)/s_1^2
/// s_109 = platform_q3_dot/s_1 - 2*platform_q3*s_11/s_1^2 - s_5*platform_q3_dot/s_1^2
///     + 4*platform_q3*s_5*s_11/s_1^3 - 2*platform_q3*s_71/s_1^2
/// s_110 = s_103 - 2*s_104 - 2*r*s_4*platform_q3_dot*cos(a1_head_angle)/s_1^2
///     - 2*platform_q3*r*s_70*cos(a1_head_angle)/s_1^2
///     + 8*platform_q3*r*s_4*s_11*cos(a1_head_angle)/s_1^3 - 2*r*s_109*sin(a1_head_angle)
/// s_111 = s_89 - 2*s_90 + s_100 - 2*s_101 - 2*r*s_6*platform_q3_dot*cos(a1_head_angle)/s_1^2
///     + 8*platform_q3*r*s_6*s_11*cos(a1_head_angle)/s_1^3
///     + 2*platform_q3*r*s_73*cos(a1_head_angle)/s_1^2
///     - 2*r*s_7*platform_q3_dot*sin(a1_head_angle)/s_1^2
///     - 2*platform_q3*r*s_74*sin(a1_head_angle)/s_1^2
///     + 8*platform_q3*r*s_7*s_11*sin(a1_head_angle)/s_1^3
/// s_112 = s_62*s_69 + s_12*s_108 - s_64*s_72 - s_13*s_110 - s_65*s_75 - a1_on_platform_z*s_111
/// s_113 = platform_q3*r*sin(a2_head_angle)/s_1
/// s_114 = 2*platform_q0*r*s_2*cos(a2_head_angle)/s_1^2
///     - 2*platform_q0*r*s_3*sin(a2_head_angle)/s_1^2 - s_113
/// s_115 = platform_q3*r*cos(a2_head_angle)/s_1
/// s_116 = s_115 - 2*platform_q0*r*s_4*cos(a2_head_angle)/s_1^2
///     + 2*platform_q0*r*s_5*sin(a2_head_angle)/s_1^2
/// s_117 = platform_q2*r*cos(a2_head_angle)/s_1
/// s_118 = platform_q1*r*sin(a2_head_angle)/s_1
/// s_119 = 2*platform_q0*r*s_6*cos(a2_head_angle)/s_1^2 + s_117 - s_118
///     + 2*platform_q0*r*s_7*sin(a2_head_angle)/s_1^2
/// s_120 = s_15*s_114 + s_16*s_116 - a2_on_platform_z*s_119
/// s_121 = platform_q2*r*sin(a2_head_angle)/s_1
/// s_122 = 2*platform_q1*r*s_2*cos(a2_head_angle)/s_1^2 + s_121
///     - 2*platform_q1*r*s_3*sin(a2_head_angle)/s_1^2
/// s_123 = s_117 - 2*platform_q1*r*s_4*cos(a2_head_angle)/s_1^2 - 2*r*s_49*sin(a2_head_angle)
/// s_124 = platform_q0*r*sin(a2_head_angle)/s_1
/// s_125 = s_115 - 2*platform_q1*r*s_6*cos(a2_head_angle)/s_1^2 + s_124
///     - 2*platform_q1*r*s_7*sin(a2_head_angle)/s_1^2
/// s_126 = s_15*s_122 + s_16*s_123 + a2_on_platform_z*s_125
/// s_127 = s_118 - 2*r*s_54*cos(a2_head_angle) - 2*platform_q2*r*s_3*sin(a2_head_angle)/s_1^2
/// s_128 = platform_q1*r*cos(a2_head_angle)/s_1
/// s_129 = s_128 - 2*platform_q2*r*s_4*cos(a2_head_angle)/s_1^2
///     + 2*platform_q2*r*s_5*sin(a2_head_angle)/s_1^2
/// s_130 = platform_q0*r*cos(a2_head_angle)/s_1
/// s_131 = s_113 - 2*platform_q2*r*s_6*cos(a2_head_angle)/s_1^2 - s_130
///     - 2*platform_q2*r*s_7*sin(a2_head_angle)/s_1^2
/// s_132 = s_15*s_127 + s_16*s_129 + a2_on_platform_z*s_131
/// s_133 = s_124 + 2*r*s_61*cos(a2_head_angle) + 2*platform_q3*r*s_3*sin(a2_head_angle)/s_1^2
/// s_134 = s_130 - 2*platform_q3*r*s_4*cos(a2_head_angle)/s_1^2 - 2*r*s_63*sin(a2_head_angle)
/// s_135 = s_121 + s_128 - 2*platform_q3*r*s_6*cos(a2_head_angle)/s_1^2
///     - 2*platform_q3*r*s_7*sin(a2_head_angle)/s_1^2
/// s_136 = s_15*s_133 - s_16*s_134 - a2_on_platform_z*s_135
/// s_137 = sway*w^2*sin(2*pi/3 + t*w)
/// s_138 = platform_x_dot + 4*r*(s_2*s_11/s_1^2 - s_67/s_1)*cos(a2_head_angle)
///     - 4*r*s_3*s_11*sin(a2_head_angle)/s_1^2 - 2*r*s_68*sin(a2_head_angle)/s_1
/// s_139 = platform_y_dot + 2*r*s_70*cos(a2_head_angle)/s_1
///     - 4*r*s_4*s_11*cos(a2_head_angle)/s_1^2
///     + 4*r*(s_5*s_11/s_1^2 - s_71/s_1)*sin(a2_head_angle)
/// s_140 = platform_z_dot - 4*r*s_6*s_11*cos(a2_head_angle)/s_1^2
///     - 2*r*s_73*cos(a2_head_angle)/s_1 + 2*r*s_74*sin(a2_head_angle)/s_1
///     - 4*r*s_7*s_11*sin(a2_head_angle)/s_1^2
/// s_141 = s_15*s_138 + s_16*s_139 + a2_on_platform_z*s_140
/// s_142 = r*platform_q3_dot*sin(a2_head_angle)/s_1
/// s_143 = platform_q3*r*s_11*sin(a2_head_angle)/s_1^2
/// s_144 = 2*r*s_2*platform_q0_dot*cos(a2_head_angle)/s_1^2
///     - 8*platform_q0*r*s_2*s_11*cos(a2_head_angle)/s_1^3
///     + 4*platform_q0*r*s_67*cos(a2_head_angle)/s_1^2
///     - 2*r*s_3*platform_q0_dot*sin(a2_head_angle)/s_1^2
///     + 8*platform_q0*r*s_3*s_11*sin(a2_head_angle)/s_1^3
///     + 2*platform_q0*r*s_68*sin(a2_head_angle)/s_1^2 - s_142 + 2*s_143
/// s_145 = r*platform_q3_dot*cos(a2_head_angle)/s_1
/// s_146 = platform_q3*r*s_11*cos(a2_head_angle)/s_1^2
/// s_147 = s_145 - 2*s_146 - 2*r*s_4*platform_q0_dot*cos(a2_head_angle)/s_1^2
///     - 2*platform_q0*r*s_70*cos(a2_head_angle)/s_1^2
///     + 8*platform_q0*r*s_4*s_11*cos(a2_head_angle)/s_1^3
///     + 2*r*s_5*platform_q0_dot*sin(a2_head_angle)/s_1^2
///     - 8*platform_q0*r*s_5*s_11*sin(a2_head_angle)/s_1^3
///     + 4*platform_q0*r*s_71*sin(a2_head_angle)/s_1^2
/// s_148 = r*platform_q2_dot*cos(a2_head_angle)/s_1
/// s_149 = platform_q2*r*s_11*cos(a2_head_angle)/s_1^2
/// s_150 = r*platform_q1_dot*sin(a2_head_angle)/s_1
/// s_151 = platform_q1*r*s_11*sin(a2_head_angle)/s_1^2
/// s_152 = 2*r*s_6*platform_q0_dot*cos(a2_head_angle)/s_1^2
///     - 8*platform_q0*r*s_6*s_11*cos(a2_head_angle)/s_1^3
///     - 2*platform_q0*r*s_73*cos(a2_head_angle)/s_1^2 + s_148 - 2*s_149 - s_150 + 2*s_151
///     + 2*r*s_7*platform_q0_dot*sin(a2_head_angle)/s_1^2
///     + 2*platform_q0*r*s_74*sin(a2_head_angle)/s_1^2
///     - 8*platform_q0*r*s_7*s_11*sin(a2_head_angle)/s_1^3
/// s_153 = s_114*s_138 + s_15*s_144 + s_116*s_139 + s_16*s_147 - s_119*s_140
///     - a2_on_platform_z*s_152
/// s_154 = r*platform_q2_dot*sin(a2_head_angle)/s_1
/// s_155 = platform_q2*r*s_11*sin(a2_head_angle)/s_1^2
/// s_156 = 2*r*s_2*platform_q1_dot*cos(a2_head_angle)/s_1^2
///     - 8*platform_q1*r*s_2*s_11*cos(a2_head_angle)/s_1^3
///     + 4*platform_q1*r*s_67*cos(a2_head_angle)/s_1^2 + s_154 - 2*s_155
///     - 2*r*s_3*platform_q1_dot*sin(a2_head_angle)/s_1^2
///     + 8*platform_q1*r*s_3*s_11*sin(a2_head_angle)/s_1^3
///     + 2*platform_q1*r*s_68*sin(a2_head_angle)/s_1^2
/// s_157 = s_148 - 2*s_149 - 2*r*s_4*platform_q1_dot*cos(a2_head_angle)/s_1^2
///     - 2*platform_q1*r*s_70*cos(a2_head_angle)/s_1^2
///     + 8*platform_q1*r*s_4*s_11*cos(a2_head_angle)/s_1^3 - 2*r*s_92*sin(a2_head_angle)
/// s_158 = r*platform_q0_dot*sin(a2_head_angle)/s_1
/// s_159 = platform_q0*r*s_11*sin(a2_head_angle)/s_1^2
/// s_160 = s_145 - 2*s_146 - 2*r*s_6*platform_q1_dot*cos(a2_head_angle)/s_1^2
///     + 8*platform_q1*r*s_6*s_11*cos(a2_head_angle)/s_1^3
///     + 2*platform_q1*r*s_73*cos(a2_head_angle)/s_1^2 + s_158 - 2*s_159
///     - 2*r*s_7*platform_q1_dot*sin(a2_head_angle)/s_1^2
///     - 2*platform_q1*r*s_74*sin(a2_head_angle)/s_1^2
///     + 8*platform_q1*r*s_7*s_11*sin(a2_head_angle)/s_1^3
/// s_161 = s_122*s_138 + s_15*s_156 + s_123*s_139 + s_16*s_157 + s_125*s_140
///     + a2_on_platform_z*s_160
/// s_162 = s_150 - 2*s_151 - 2*r*s_98*cos(a2_head_angle)
///     - 2*r*s_3*platform_q2_dot*sin(a2_head_angle)/s_1^2
///     + 8*platform_q2*r*s_3*s_11*sin(a2_head_angle)/s_1^3
///     + 2*platform_q2*r*s_68*sin(a2_head_angle)/s_1^2
/// s_163 = r*platform_q1_dot*cos(a2_head_angle)/s_1
/// s_164 = platform_q1*r*s_11*cos(a2_head_angle)/s_1^2
/// s_165 = s_163 - 2*s_164 - 2*r*s_4*platform_q2_dot*cos(a2_head_angle)/s_1^2
///     - 2*platform_q2*r*s_70*cos(a2_head_angle)/s_1^2
///     + 8*platform_q2*r*s_4*s_11*cos(a2_head_angle)/s_1^3
///     + 2*r*s_5*platform_q2_dot*sin(a2_head_angle)/s_1^2
///     - 8*platform_q2*r*s_5*s_11*sin(a2_head_angle)/s_1^3
///     + 4*platform_q2*r*s_71*sin(a2_head_angle)/s_1^2
/// s_166 = r*platform_q0_dot*cos(a2_head_angle)/s_1
/// s_167 = platform_q0*r*s_11*cos(a2_head_angle)/s_1^2
/// s_168 = s_142 - 2*s_143 - 2*r*s_6*platform_q2_dot*cos(a2_head_angle)/s_1^2
///     + 8*platform_q2*r*s_6*s_11*cos(a2_head_angle)/s_1^3
///     + 2*platform_q2*r*s_73*cos(a2_head_angle)/s_1^2 - s_166 + 2*s_167
///     - 2*r*s_7*platform_q2_dot*sin(a2_head_angle)/s_1^2
///     - 2*platform_q2*r*s_74*sin(a2_head_angle)/s_1^2
///     + 8*platform_q2*r*s_7*s_11*sin(a2_head_angle)/s_1^3
/// s_169 = s_127*s_138 + s_15*s_162 + s_129*s_139 + s_16*s_165 + s_131*s_140
///     + a2_on_platform_z*s_168
/// s_170 = s_158 - 2*s_159 + 2*r*s_107*cos(a2_head_angle)
///     + 2*r*s_3*platform_q3_dot*sin(a2_head_angle)/s_1^2
///     - 8*platform_q3*r*s_3*s_11*sin(a2_head_angle)/s_1^3
///     - 2*platform_q3*r*s_68*sin(a2_head_angle)/s_1^2
/// s_171 = s_166 - 2*s_167 - 2*r*s_4*platform_q3_dot*cos(a2_head_angle)/s_1^2
///     - 2*platform_q3*r*s_70*cos(a2_head_angle)/s_1^2
///     + 8*platform_q3*r*s_4*s_11*cos(a2_head_angle)/s_1^3 - 2*r*s_109*sin(a2_head_angle)
/// s_172 = s_154 - 2*s_155 + s_163 - 2*s_164 - 2*r*s_6*platform_q3_dot*cos(a2_head_angle)/s_1^2
///     + 8*platform_q3*r*s_6*s_11*cos(a2_head_angle)/s_1^3
///     + 2*platform_q3*r*s_73*cos(a2_head_angle)/s_1^2
///     - 2*r*s_7*platform_q3_dot*sin(a2_head_angle)/s_1^2
///     - 2*platform_q3*r*s_74*sin(a2_head_angle)/s_1^2
///     + 8*platform_q3*r*s_7*s_11*sin(a2_head_angle)/s_1^3
/// s_173 = s_133*s_138 + s_15*s_170 - s_134*s_139 - s_16*s_171 - s_135*s_140
///     - a2_on_platform_z*s_172
/// s_174 = platform_q3*r*sin(b1_head_angle)/s_1
/// s_175 = 2*platform_q0*r*s_2*cos(b1_head_angle)/s_1^2
///     - 2*platform_q0*r*s_3*sin(b1_head_angle)/s_1^2 - s_174
/// s_176 = platform_q3*r*cos(b1_head_angle)/s_1
/// s_177 = s_176 - 2*platform_q0*r*s_4*cos(b1_head_angle)/s_1^2
///     + 2*platform_q0*r*s_5*sin(b1_head_angle)/s_1^2
/// s_178 = platform_q2*r*cos(b1_head_angle)/s_1
/// s_179 = platform_q1*r*sin(b1_head_angle)/s_1
/// s_180 = 2*platform_q0*r*s_6*cos(b1_head_angle)/s_1^2 + s_178 - s_179
///     + 2*platform_q0*r*s_7*sin(b1_head_angle)/s_1^2
/// s_181 = s_19*s_175 + s_20*s_177 - b1_on_platform_z*s_180
/// s_182 = platform_q2*r*sin(b1_head_angle)/s_1
/// s_183 = 2*platform_q1*r*s_2*cos(b1_head_angle)/s_1^2 + s_182
///     - 2*platform_q1*r*s_3*sin(b1_head_angle)/s_1^2
/// s_184 = s_178 - 2*platform_q1*r*s_4*cos(b1_head_angle)/s_1^2 - 2*r*s_49*sin(b1_head_angle)
/// s_185 = platform_q0*r*sin(b1_head_angle)/s_1
/// s_186 = s_176 - 2*platform_q1*r*s_6*cos(b1_head_angle)/s_1^2 + s_185
///     - 2*platform_q1*r*s_7*sin(b1_head_angle)/s_1^2
/// s_187 = s_19*s_183 + s_20*s_184 + b1_on_platform_z*s_186
/// s_188 = s_179 - 2*r*s_54*cos(b1_head_angle) - 2*platform_q2*r*s_3*sin(b1_head_angle)/s_1^2
/// s_189 = platform_q1*r*cos(b1_head_angle)/s_1
/// s_190 = s_189 - 2*platform_q2*r*s_4*cos(b1_head_angle)/s_1^2
///     + 2*platform_q2*r*s_5*sin(b1_head_angle)/s_1^2
/// s_191 = platform_q0*r*cos(b1_head_angle)/s_1
/// s_192 = s_174 - 2*platform_q2*r*s_6*cos(b1_head_angle)/s_1^2 - s_191
///     - 2*platform_q2*r*s_7*sin(b1_head_angle)/s_1^2
/// s_193 = s_19*s_188 + s_20*s_190 + b1_on_platform_z*s_192
/// s_194 = s_185 + 2*r*s_61*cos(b1_head_angle) + 2*platform_q3*r*s_3*sin(b1_head_angle)/s_1^2
/// s_195 = s_191 - 2*platform_q3*r*s_4*cos(b1_head_angle)/s_1^2 - 2*r*s_63*sin(b1_head_angle)
/// s_196 = s_182 + s_189 - 2*platform_q3*r*s_6*cos(b1_head_angle)/s_1^2
///     - 2*platform_q3*r*s_7*sin(b1_head_angle)/s_1^2
/// s_197 = s_19*s_194 - s_20*s_195 - b1_on_platform_z*s_196
/// s_198 = platform_x_dot + 4*r*(s_2*s_11/s_1^2 - s_67/s_1)*cos(b1_head_angle)
///     - 4*r*s_3*s_11*sin(b1_head_angle)/s_1^2 - 2*r*s_68*sin(b1_head_angle)/s_1
/// s_199 = platform_y_dot + 2*r*s_70*cos(b1_head_angle)/s_1
///     - 4*r*s_4*s_11*cos(b1_head_angle)/s_1^2
///     + 4*r*(s_5*s_11/s_1^2 - s_71/s_1)*sin(b1_head_angle)
/// s_200 = platform_z_dot - 4*r*s_6*s_11*cos(b1_head_angle)/s_1^2
///     - 2*r*s_73*cos(b1_head_angle)/s_1 + 2*r*s_74*sin(b1_head_angle)/s_1
///     - 4*r*s_7*s_11*sin(b1_head_angle)/s_1^2
/// s_201 = s_19*s_198 + s_20*s_199 + b1_on_platform_z*s_200
/// s_202 = r*platform_q3_dot*sin(b1_head_angle)/s_1
/// s_203 = platform_q3*r*s_11*sin(b1_head_angle)/s_1^2
/// s_204 = 2*r*s_2*platform_q0_dot*cos(b1_head_angle)/s_1^2
///     - 8*platform_q0*r*s_2*s_11*cos(b1_head_angle)/s_1^3
///     + 4*platform_q0*r*s_67*cos(b1_head_angle)/s_1^2
///     - 2*r*s_3*platform_q0_dot*sin(b1_head_angle)/s_1^2
///     + 8*platform_q0*r*s_3*s_11*sin(b1_head_angle)/s_1^3
///     + 2*platform_q0*r*s_68*sin(b1_head_angle)/s_1^2 - s_202 + 2*s_203
/// s_205 = r*platform_q3_dot*cos(b1_head_angle)/s_1
/// s_206 = platform_q3*r*s_11*cos(b1_head_angle)/s_1^2
/// s_207 = s_205 - 2*s_206 - 2*r*s_4*platform_q0_dot*cos(b1_head_angle)/s_1^2
///     - 2*platform_q0*r*s_70*cos(b1_head_angle)/s_1^2
///     + 8*platform_q0*r*s_4*s_11*cos(b1_head_angle)/s_1^3
///     + 2*r*s_5*platform_q0_dot*sin(b1_head_angle)/s_1^2
///     - 8*platform_q0*r*s_5*s_11*sin(b1_head_angle)/s_1^3
///     + 4*platform_q0*r*s_71*sin(b1_head_angle)/s_1^2
/// s_208 = r*platform_q2_dot*cos(b1_head_angle)/s_1
/// s_209 = platform_q2*r*s_11*cos(b1_head_angle)/s_1^2
/// s_210 = r*platform_q1_dot*sin(b1_head_angle)/s_1
/// s_211 = platform_q1*r*s_11*sin(b1_head_angle)/s_1^2
/// s_212 = 2*r*s_6*platform_q0_dot*cos(b1_head_angle)/s_1^2
///     - 8*platform_q0*r*s_6*s_11*cos(b1_head_angle)/s_1^3
///     - 2*platform_q0*r*s_73*cos(b1_head_angle)/s_1^2 + s_208 - 2*s_209 - s_210 + 2*s_211
///     + 2*r*s_7*platform_q0_dot*sin(b1_head_angle)/s_1^2
///     + 2*platform_q0*r*s_74*sin(b1_head_angle)/s_1^2
///     - 8*platform_q0*r*s_7*s_11*sin(b1_head_angle)/s_1^3
/// s_213 = s_175*s_198 + s_19*s_204 + s_177*s_199 + s_20*s_207 - s_180*s_200
///     - b1_on_platform_z*s_212
/// s_214 = r*platform_q2_dot*sin(b1_head_angle)/s_1
/// s_215 = platform_q2*r*s_11*sin(b1_head_angle)/s_1^2
/// s_216 = 2*r*s_2*platform_q1_dot*cos(b1_head_angle)/s_1^2
///     - 8*platform_q1*r*s_2*s_11*cos(b1_head_angle)/s_1^3
///     + 4*platform_q1*r*s_67*cos(b1_head_angle)/s_1^2 + s_214 - 2*s_215
///     - 2*r*s_3*platform_q1_dot*sin(b1_head_angle)/s_1^2
///     + 8*platform_q1*r*s_3*s_11*sin(b1_head_angle)/s_1^3
///     + 2*platform_q1*r*s_68*sin(b1_head_angle)/s_1^2
/// s_217 = s_208 - 2*s_209 - 2*r*s_4*platform_q1_dot*cos(b1_head_angle)/s_1^2
///     - 2*platform_q1*r*s_70*cos(b1_head_angle)/s_1^2
///     + 8*platform_q1*r*s_4*s_11*cos(b1_head_angle)/s_1^3 - 2*r*s_92*sin(b1_head_angle)
/// s_218 = r*platform_q0_dot*sin(b1_head_angle)/s_1
/// s_219 = platform_q0*r*s_11*sin(b1_head_angle)/s_1^2
/// s_220 = s_205 - 2*s_206 - 2*r*s_6*platform_q1_dot*cos(b1_head_angle)/s_1^2
///     + 8*platform_q1*r*s_6*s_11*cos(b1_head_angle)/s_1^3
///     + 2*platform_q1*r*s_73*cos(b1_head_angle)/s_1^2 + s_218 - 2*s_219
///     - 2*r*s_7*platform_q1_dot*sin(b1_head_angle)/s_1^2
///     - 2*platform_q1*r*s_74*sin(b1_head_angle)/s_1^2
///     + 8*platform_q1*r*s_7*s_11*sin(b1_head_angle)/s_1^3
/// s_221 = s_183*s_198 + s_19*s_216 + s_184*s_199 + s_20*s_217 + s_186*s_200
///     + b1_on_platform_z*s_220
/// s_222 = s_210 - 2*s_211 - 2*r*s_98*cos(b1_head_angle)
///     - 2*r*s_3*platform_q2_dot*sin(b1_head_angle)/s_1^2
///     + 8*platform_q2*r*s_3*s_11*sin(b1_head_angle)/s_1^3
///     + 2*platform_q2*r*s_68*sin(b1_head_angle)/s_1^2
/// s_223 = r*platform_q1_dot*cos(b1_head_angle)/s_1
/// s_224 = platform_q1*r*s_11*cos(b1_head_angle)/s_1^2
/// s_225 = s_223 - 2*s_224 - 2*r*s_4*platform_q2_dot*cos(b1_head_angle)/s_1^2
///     - 2*platform_q2*r*s_70*cos(b1_head_angle)/s_1^2
///     + 8*platform_q2*r*s_4*s_11*cos(b1_head_angle)/s_1^3
///     + 2*r*s_5*platform_q2_dot*sin(b1_head_angle)/s_1^2
///     - 8*platform_q2*r*s_5*s_11*sin(b1_head_angle)/s_1^3
///     + 4*platform_q2*r*s_71*sin(b1_head_angle)/s_1^2
/// s_226 = r*platform_q0_dot*cos(b1_head_angle)/s_1
/// s_227 = platform_q0*r*s_11*cos(b1_head_angle)/s_1^2
/// s_228 = s_202 - 2*s_203 - 2*r*s_6*platform_q2_dot*cos(b1_head_angle)/s_1^2
///     + 8*platform_q2*r*s_6*s_11*cos(b1_head_angle)/s_1^3
///     + 2*platform_q2*r*s_73*cos(b1_head_angle)/s_1^2 - s_226 + 2*s_227
///     - 2*r*s_7*platform_q2_dot*sin(b1_head_angle)/s_1^2
///     - 2*platform_q2*r*s_74*sin(b1_head_angle)/s_1^2
///     + 8*platform_q2*r*s_7*s_11*sin(b1_head_angle)/s_1^3
/// s_229 = s_188*s_198 + s_19*s_222 + s_190*s_199 + s_20*s_225 + s_192*s_200
///     + b1_on_platform_z*s_228
/// s_230 = s_218 - 2*s_219 + 2*r*s_107*cos(b1_head_angle)
///     + 2*r*s_3*platform_q3_dot*sin(b1_head_angle)/s_1^2
///     - 8*platform_q3*r*s_3*s_11*sin(b1_head_angle)/s_1^3
///     - 2*platform_q3*r*s_68*sin(b1_head_angle)/s_1^2
/// s_231 = s_226 - 2*s_227 - 2*r*s_4*platform_q3_dot*cos(b1_head_angle)/s_1^2
///     - 2*platform_q3*r*s_70*cos(b1_head_angle)/s_1^2
///     + 8*platform_q3*r*s_4*s_11*cos(b1_head_angle)/s_1^3 - 2*r*s_109*sin(b1_head_angle)
/// s_232 = s_214 - 2*s_215 + s_223 - 2*s_224 - 2*r*s_6*platform_q3_dot*cos(b1_head_angle)/s_1^2
///     + 8*platform_q3*r*s_6*s_11*cos(b1_head_angle)/s_1^3
///     + 2*platform_q3*r*s_73*cos(b1_head_angle)/s_1^2
///     - 2*r*s_7*platform_q3_dot*sin(b1_head_angle)/s_1^2
///     - 2*platform_q3*r*s_74*sin(b1_head_angle)/s_1^2
///     + 8*platform_q3*r*s_7*s_11*sin(b1_head_angle)/s_1^3
/// s_233 = s_194*s_198 + s_19*s_230 - s_195*s_199 - s_20*s_231 - s_196*s_200
///     - b1_on_platform_z*s_232
/// s_234 = platform_q3*r*sin(b2_head_angle)/s_1
/// s_235 = 2*platform_q0*r*s_2*cos(b2_head_angle)/s_1^2
///     - 2*platform_q0*r*s_3*sin(b2_head_angle)/s_1^2 - s_234
/// s_236 = platform_q3*r*cos(b2_head_angle)/s_1
/// s_237 = s_236 - 2*platform_q0*r*s_4*cos(b2_head_angle)/s_1^2
///     + 2*platform_q0*r*s_5*sin(b2_head_angle)/s_1^2
/// s_238 = platform_q2*r*cos(b2_head_angle)/s_1
/// s_239 = platform_q1*r*sin(b2_head_angle)/s_1
/// s_240 = 2*platform_q0*r*s_6*cos(b2_head_angle)/s_1^2 + s_238 - s_239
///     + 2*platform_q0*r*s_7*sin(b2_head_angle)/s_1^2
/// s_241 = s_22*s_235 + s_23*s_237 - b2_on_platform_z*s_240
/// s_242 = platform_q2*r*sin(b2_head_angle)/s_1
/// s_243 = 2*platform_q1*r*s_2*cos(b2_head_angle)/s_1^2 + s_242
///     - 2*platform_q1*r*s_3*sin(b2_head_angle)/s_1^2
/// s_244 = s_238 - 2*platform_q1*r*s_4*cos(b2_head_angle)/s_1^2 - 2*r*s_49*sin(b2_head_angle)
/// s_245 = platform_q0*r*sin(b2_head_angle)/s_1
/// s_246 = s_236 - 2*platform_q1*r*s_6*cos(b2_head_angle)/s_1^2 + s_245
///     - 2*platform_q1*r*s_7*sin(b2_head_angle)/s_1^2
/// s_247 = s_22*s_243 + s_23*s_244 + b2_on_platform_z*s_246
/// s_248 = s_239 - 2*r*s_54*cos(b2_head_angle) - 2*platform_q2*r*s_3*sin(b2_head_angle)/s_1^2
/// s_249 = platform_q1*r*cos(b2_head_angle)/s_1
/// s_250 = s_249 - 2*platform_q2*r*s_4*cos(b2_head_angle)/s_1^2
///     + 2*platform_q2*r*s_5*sin(b2_head_angle)/s_1^2
/// s_251 = platform_q0*r*cos(b2_head_angle)/s_1
/// s_252 = s_234 - 2*platform_q2*r*s_6*cos(b2_head_angle)/s_1^2 - s_251
///     - 2*platform_q2*r*s_7*sin(b2_head_angle)/s_1^2
/// s_253 = s_22*s_248 + s_23*s_250 + b2_on_platform_z*s_252
/// s_254 = s_245 + 2*r*s_61*cos(b2_head_angle) + 2*platform_q3*r*s_3*sin(b2_head_angle)/s_1^2
/// s_255 = s_251 - 2*platform_q3*r*s_4*cos(b2_head_angle)/s_1^2 - 2*r*s_63*sin(b2_head_angle)
/// s_256 = s_242 + s_249 - 2*platform_q3*r*s_6*cos(b2_head_angle)/s_1^2
///     - 2*platform_q3*r*s_7*sin(b2_head_angle)/s_1^2
/// s_257 = s_22*s_254 - s_23*s_255 - b2_on_platform_z*s_256
/// s_258 = sway*w^2*sin(4*pi/3 + t*w)
/// s_259 = platform_x_dot + 4*r*(s_2*s_11/s_1^2 - s_67/s_1)*cos(b2_head_angle)
///     - 4*r*s_3*s_11*sin(b2_head_angle)/s_1^2 - 2*r*s_68*sin(b2_head_angle)/s_1
/// s_260 = platform_y_dot + 2*r*s_70*cos(b2_head_angle)/s_1
///     - 4*r*s_4*s_11*cos(b2_head_angle)/s_1^2
///     + 4*r*(s_5*s_11/s_1^2 - s_71/s_1)*sin(b2_head_angle)
/// s_261 = platform_z_dot - 4*r*s_6*s_11*cos(b2_head_angle)/s_1^2
///     - 2*r*s_73*cos(b2_head_angle)/s_1 + 2*r*s_74*sin(b2_head_angle)/s_1
///     - 4*r*s_7*s_11*sin(b2_head_angle)/s_1^2
/// s_262 = s_22*s_259 + s_23*s_260 + b2_on_platform_z*s_261
/// s_263 = r*platform_q3_dot*sin(b2_head_angle)/s_1
/// s_264 = platform_q3*r*s_11*sin(b2_head_angle)/s_1^2
/// s_265 = 2*r*s_2*platform_q0_dot*cos(b2_head_angle)/s_1^2
///     - 8*platform_q0*r*s_2*s_11*cos(b2_head_angle)/s_1^3
///     + 4*platform_q0*r*s_67*cos(b2_head_angle)/s_1^2
///     - 2*r*s_3*platform_q0_dot*sin(b2_head_angle)/s_1^2
///     + 8*platform_q0*r*s_3*s_11*sin(b2_head_angle)/s_1^3
///     + 2*platform_q0*r*s_68*sin(b2_head_angle)/s_1^2 - s_263 + 2*s_264
/// s_266 = r*platform_q3_dot*cos(b2_head_angle)/s_1
/// s_267 = platform_q3*r*s_11*cos(b2_head_angle)/s_1^2
/// s_268 = s_266 - 2*s_267 - 2*r*s_4*platform_q0_dot*cos(b2_head_angle)/s_1^2
///     - 2*platform_q0*r*s_70*cos(b2_head_angle)/s_1^2
///     + 8*platform_q0*r*s_4*s_11*cos(b2_head_angle)/s_1^3
///     + 2*r*s_5*platform_q0_dot*sin(b2_head_angle)/s_1^2
///     - 8*platform_q0*r*s_5*s_11*sin(b2_head_angle)/s_1^3
///     + 4*platform_q0*r*s_71*sin(b2_head_angle)/s_1^2
/// s_269 = r*platform_q2_dot*cos(b2_head_angle)/s_1
/// s_270 = platform_q2*r*s_11*cos(b2_head_angle)/s_1^2
/// s_271 = r*platform_q1_dot*sin(b2_head_angle)/s_1
/// s_272 = platform_q1*r*s_11*sin(b2_head_angle)/s_1^2
/// s_273 = 2*r*s_6*platform_q0_dot*cos(b2_head_angle)/s_1^2
///     - 8*platform_q0*r*s_6*s_11*cos(b2_head_angle)/s_1^3
///     - 2*platform_q0*r*s_73*cos(b2_head_angle)/s_1^2 + s_269 - 2*s_270 - s_271 + 2*s_272
///     + 2*r*s_7*platform_q0_dot*sin(b2_head_angle)/s_1^2
///     + 2*platform_q0*r*s_74*sin(b2_head_angle)/s_1^2
///     - 8*platform_q0*r*s_7*s_11*sin(b2_head_angle)/s_1^3
/// s_274 = s_235*s_259 + s_22*s_265 + s_237*s_260 + s_23*s_268 - s_240*s_261
///     - b2_on_platform_z*s_273
/// s_275 = r*platform_q2_dot*sin(b2_head_angle)/s_1
/// s_276 = platform_q2*r*s_11*sin(b2_head_angle)/s_1^2
/// s_277 = 2*r*s_2*platform_q1_dot*cos(b2_head_angle)/s_1^2
///     - 8*platform_q1*r*s_2*s_11*cos(b2_head_angle)/s_1^3
///     + 4*platform_q1*r*s_67*cos(b2_head_angle)/s_1^2 + s_275 - 2*s_276
///     - 2*r*s_3*platform_q1_dot*sin(b2_head_angle)/s_1^2
///     + 8*platform_q1*r*s_3*s_11*sin(b2_head_angle)/s_1^3
///     + 2*platform_q1*r*s_68*sin(b2_head_angle)/s_1^2
/// s_278 = s_269 - 2*s_270 - 2*r*s_4*platform_q1_dot*cos(b2_head_angle)/s_1^2
///     - 2*platform_q1*r*s_70*cos(b2_head_angle)/s_1^2
///     + 8*platform_q1*r*s_4*s_11*cos(b2_head_angle)/s_1^3 - 2*r*s_92*sin(b2_head_angle)
/// s_279 = r*platform_q0_dot*sin(b2_head_angle)/s_1
/// s_280 = platform_q0*r*s_11*sin(b2_head_angle)/s_1^2
/// s_281 = s_266 - 2*s_267 - 2*r*s_6*platform_q1_dot*cos(b2_head_angle)/s_1^2
///     + 8*platform_q1*r*s_6*s_11*cos(b2_head_angle)/s_1^3
///     + 2*platform_q1*r*s_73*cos(b2_head_angle)/s_1^2 + s_279 - 2*s_280
///     - 2*r*s_7*platform_q1_dot*sin(b2_head_angle)/s_1^2
///     - 2*platform_q1*r*s_74*sin(b2_head_angle)/s_1^2
///     + 8*platform_q1*r*s_7*s_11*sin(b2_head_angle)/s_1^3
/// s_282 = s_243*s_259 + s_22*s_277 + s_244*s_260 + s_23*s_278 + s_246*s_261
///     + b2_on_platform_z*s_281
/// s_283 = s_271 - 2*s_272 - 2*r*s_98*cos(b2_head_angle)
///     - 2*r*s_3*platform_q2_dot*sin(b2_head_angle)/s_1^2
///     + 8*platform_q2*r*s_3*s_11*sin(b2_head_angle)/s_1^3
///     + 2*platform_q2*r*s_68*sin(b2_head_angle)/s_1^2
/// s_284 = r*platform_q1_dot*cos(b2_head_angle)/s_1
/// s_285 = platform_q1*r*s_11*cos(b2_head_angle)/s_1^2
/// s_286 = s_284 - 2*s_285 - 2*r*s_4*platform_q2_dot*cos(b2_head_angle)/s_1^2
///     - 2*platform_q2*r*s_70*cos(b2_head_angle)/s_1^2
///     + 8*platform_q2*r*s_4*s_11*cos(b2_head_angle)/s_1^3
///     + 2*r*s_5*platform_q2_dot*sin(b2_head_angle)/s_1^2
///     - 8*platform_q2*r*s_5*s_11*sin(b2_head_angle)/s_1^3
///     + 4*platform_q2*r*s_71*sin(b2_head_angle)/s_1^2
/// s_287 = r*platform_q0_dot*cos(b2_head_angle)/s_1
/// s_288 = platform_q0*r*s_11*cos(b2_head_angle)/s_1^2
/// s_289 = s_263 - 2*s_264 - 2*r*s_6*platform_q2_dot*cos(b2_head_angle)/s_1^2
///     + 8*platform_q2*r*s_6*s_11*cos(b2_head_angle)/s_1^3
///     + 2*platform_q2*r*s_73*cos(b2_head_angle)/s_1^2 - s_287 + 2*s_288
///     - 2*r*s_7*platform_q2_dot*sin(b2_head_angle)/s_1^2
///     - 2*platform_q2*r*s_74*sin(b2_head_angle)/s_1^2
///     + 8*platform_q2*r*s_7*s_11*sin(b2_head_angle)/s_1^3
/// s_290 = s_248*s_259 + s_22*s_283 + s_250*s_260 + s_23*s_286 + s_252*s_261
///     + b2_on_platform_z*s_289
/// s_291 = s_279 - 2*s_280 + 2*r*s_107*cos(b2_head_angle)
///     + 2*r*s_3*platform_q3_dot*sin(b2_head_angle)/s_1^2
///     - 8*platform_q3*r*s_3*s_11*sin(b2_head_angle)/s_1^3
///     - 2*platform_q3*r*s_68*sin(b2_head_angle)/s_1^2
/// s_292 = s_287 - 2*s_288 - 2*r*s_4*platform_q3_dot*cos(b2_head_angle)/s_1^2
///     - 2*platform_q3*r*s_70*cos(b2_head_angle)/s_1^2
///     + 8*platform_q3*r*s_4*s_11*cos(b2_head_angle)/s_1^3 - 2*r*s_109*sin(b2_head_angle)
/// s_293 = s_275 - 2*s_276 + s_284 - 2*s_285 - 2*r*s_6*platform_q3_dot*cos(b2_head_angle)/s_1^2
///     + 8*platform_q3*r*s_6*s_11*cos(b2_head_angle)/s_1^3
///     + 2*platform_q3*r*s_73*cos(b2_head_angle)/s_1^2
///     - 2*r*s_7*platform_q3_dot*sin(b2_head_angle)/s_1^2
///     - 2*platform_q3*r*s_74*sin(b2_head_angle)/s_1^2
///     + 8*platform_q3*r*s_7*s_11*sin(b2_head_angle)/s_1^3
/// s_294 = s_254*s_259 + s_22*s_291 - s_255*s_260 - s_23*s_292 - s_256*s_261
///     - b2_on_platform_z*s_293
/// s_295 = platform_q3*r*sin(c1_head_angle)/s_1
/// s_296 = 2*platform_q0*r*s_2*cos(c1_head_angle)/s_1^2
///     - 2*platform_q0*r*s_3*sin(c1_head_angle)/s_1^2 - s_295
/// s_297 = platform_q3*r*cos(c1_head_angle)/s_1
/// s_298 = s_297 - 2*platform_q0*r*s_4*cos(c1_head_angle)/s_1^2
///     + 2*platform_q0*r*s_5*sin(c1_head_angle)/s_1^2
/// s_299 = platform_q2*r*cos(c1_head_angle)/s_1
/// s_300 = platform_q1*r*sin(c1_head_angle)/s_1
/// s_301 = 2*platform_q0*r*s_6*cos(c1_head_angle)/s_1^2 + s_299 - s_300
///     + 2*platform_q0*r*s_7*sin(c1_head_angle)/s_1^2
/// s_302 = s_26*s_296 + s_27*s_298 - c1_on_platform_z*s_301
/// s_303 = platform_q2*r*sin(c1_head_angle)/s_1
/// s_304 = 2*platform_q1*r*s_2*cos(c1_head_angle)/s_1^2 + s_303
///     - 2*platform_q1*r*s_3*sin(c1_head_angle)/s_1^2
/// s_305 = s_299 - 2*platform_q1*r*s_4*cos(c1_head_angle)/s_1^2 - 2*r*s_49*sin(c1_head_angle)
/// s_306 = platform_q0*r*sin(c1_head_angle)/s_1
/// s_307 = s_297 - 2*platform_q1*r*s_6*cos(c1_head_angle)/s_1^2 + s_306
///     - 2*platform_q1*r*s_7*sin(c1_head_angle)/s_1^2
/// s_308 = s_26*s_304 + s_27*s_305 + c1_on_platform_z*s_307
/// s_309 = s_300 - 2*r*s_54*cos(c1_head_angle) - 2*platform_q2*r*s_3*sin(c1_head_angle)/s_1^2
/// s_310 = platform_q1*r*cos(c1_head_angle)/s_1
/// s_311 = s_310 - 2*platform_q2*r*s_4*cos(c1_head_angle)/s_1^2
///     + 2*platform_q2*r*s_5*sin(c1_head_angle)/s_1^2
/// s_312 = platform_q0*r*cos(c1_head_angle)/s_1
/// s_313 = s_295 - 2*platform_q2*r*s_6*cos(c1_head_angle)/s_1^2 - s_312
///     - 2*platform_q2*r*s_7*sin(c1_head_angle)/s_1^2
/// s_314 = s_26*s_309 + s_27*s_311 + c1_on_platform_z*s_313
/// s_315 = s_306 + 2*r*s_61*cos(c1_head_angle) + 2*platform_q3*r*s_3*sin(c1_head_angle)/s_1^2
/// s_316 = s_312 - 2*platform_q3*r*s_4*cos(c1_head_angle)/s_1^2 - 2*r*s_63*sin(c1_head_angle)
/// s_317 = s_303 + s_310 - 2*platform_q3*r*s_6*cos(c1_head_angle)/s_1^2
///     - 2*platform_q3*r*s_7*sin(c1_head_angle)/s_1^2
/// s_318 = s_26*s_315 - s_27*s_316 - c1_on_platform_z*s_317
/// s_319 = platform_x_dot + 4*r*(s_2*s_11/s_1^2 - s_67/s_1)*cos(c1_head_angle)
///     - 4*r*s_3*s_11*sin(c1_head_angle)/s_1^2 - 2*r*s_68*sin(c1_head_angle)/s_1
/// s_320 = platform_y_dot + 2*r*s_70*cos(c1_head_angle)/s_1
///     - 4*r*s_4*s_11*cos(c1_head_angle)/s_1^2
///     + 4*r*(s_5*s_11/s_1^2 - s_71/s_1)*sin(c1_head_angle)
/// s_321 = platform_z_dot - 4*r*s_6*s_11*cos(c1_head_angle)/s_1^2
///     - 2*r*s_73*cos(c1_head_angle)/s_1 + 2*r*s_74*sin(c1_head_angle)/s_1
///     - 4*r*s_7*s_11*sin(c1_head_angle)/s_1^2
/// s_322 = s_26*s_319 + s_27*s_320 + c1_on_platform_z*s_321
/// s_323 = r*platform_q3_dot*sin(c1_head_angle)/s_1
/// s_324 = platform_q3*r*s_11*sin(c1_head_angle)/s_1^2
/// s_325 = 2*r*s_2*platform_q0_dot*cos(c1_head_angle)/s_1^2
///     - 8*platform_q0*r*s_2*s_11*cos(c1_head_angle)/s_1^3
///     + 4*platform_q0*r*s_67*cos(c1_head_angle)/s_1^2
///     - 2*r*s_3*platform_q0_dot*sin(c1_head_angle)/s_1^2
///     + 8*platform_q0*r*s_3*s_11*sin(c1_head_angle)/s_1^3
///     + 2*platform_q0*r*s_68*sin(c1_head_angle)/s_1^2 - s_323 + 2*s_324
/// s_326 = r*platform_q3_dot*cos(c1_head_angle)/s_1
/// s_327 = platform_q3*r*s_11*cos(c1_head_angle)/s_1^2
/// s_328 = s_326 - 2*s_327 - 2*r*s_4*platform_q0_dot*cos(c1_head_angle)/s_1^2
///     - 2*platform_q0*r*s_70*cos(c1_head_angle)/s_1^2
///     + 8*platform_q0*r*s_4*s_11*cos(c1_head_angle)/s_1^3
///     + 2*r*s_5*platform_q0_dot*sin(c1_head_angle)/s_1^2
///     - 8*platform_q0*r*s_5*s_11*sin(c1_head_angle)/s_1^3
///     + 4*platform_q0*r*s_71*sin(c1_head_angle)/s_1^2
/// s_329 = r*platform_q2_dot*cos(c1_head_angle)/s_1
/// s_330 = platform_q2*r*s_11*cos(c1_head_angle)/s_1^2
/// s_331 = r*platform_q1_dot*sin(c1_head_angle)/s_1
/// s_332 = platform_q1*r*s_11*sin(c1_head_angle)/s_1^2
/// s_333 = 2*r*s_6*platform_q0_dot*cos(c1_head_angle)/s_1^2
///     - 8*platform_q0*r*s_6*s_11*cos(c1_head_angle)/s_1^3
///     - 2*platform_q0*r*s_73*cos(c1_head_angle)/s_1^2 + s_329 - 2*s_330 - s_331 + 2*s_332
///     + 2*r*s_7*platform_q0_dot*sin(c1_head_angle)/s_1^2
///     + 2*platform_q0*r*s_74*sin(c1_head_angle)/s_1^2
///     - 8*platform_q0*r*s_7*s_11*sin(c1_head_angle)/s_1^3
/// s_334 = s_296*s_319 + s_26*s_325 + s_298*s_320 + s_27*s_328 - s_301*s_321
///     - c1_on_platform_z*s_333
/// s_335 = r*platform_q2_dot*sin(c1_head_angle)/s_1
/// s_336 = platform_q2*r*s_11*sin(c1_head_angle)/s_1^2
/// s_337 = 2*r*s_2*platform_q1_dot*cos(c1_head_angle)/s_1^2
///     - 8*platform_q1*r*s_2*s_11*cos(c1_head_angle)/s_1^3
///     + 4*platform_q1*r*s_67*cos(c1_head_angle)/s_1^2 + s_335 - 2*s_336
///     - 2*r*s_3*platform_q1_dot*sin(c1_head_angle)/s_1^2
///     + 8*platform_q1*r*s_3*s_11*sin(c1_head_angle)/s_1^3
///     + 2*platform_q1*r*s_68*sin(c1_head_angle)/s_1^2
/// s_338 = s_329 - 2*s_330 - 2*r*s_4*platform_q1_dot*cos(c1_head_angle)/s_1^2
///     - 2*platform_q1*r*s_70*cos(c1_head_angle)/s_1^2
///     + 8*platform_q1*r*s_4*s_11*cos(c1_head_angle)/s_1^3 - 2*r*s_92*sin(c1_head_angle)
/// s_339 = r*platform_q0_dot*sin(c1_head_angle)/s_1
/// s_340 = platform_q0*r*s_11*sin(c1_head_angle)/s_1^2
/// s_341 = s_326 - 2*s_327 - 2*r*s_6*platform_q1_dot*cos(c1_head_angle)/s_1^2
///     + 8*platform_q1*r*s_6*s_11*cos(c1_head_angle)/s_1^3
///     + 2*platform_q1*r*s_73*cos(c1_head_angle)/s_1^2 + s_339 - 2*s_340
///     - 2*r*s_7*platform_q1_dot*sin(c1_head_angle)/s_1^2
///     - 2*platform_q1*r*s_74*sin(c1_head_angle)/s_1^2
///     + 8*platform_q1*r*s_7*s_11*sin(c1_head_angle)/s_1^3
/// s_342 = s_304*s_319 + s_26*s_337 + s_305*s_320 + s_27*s_338 + s_307*s_321
///     + c1_on_platform_z*s_341
/// s_343 = s_331 - 2*s_332 - 2*r*s_98*cos(c1_head_angle)
///     - 2*r*s_3*platform_q2_dot*sin(c1_head_angle)/s_1^2
///     + 8*platform_q2*r*s_3*s_11*sin(c1_head_angle)/s_1^3
///     + 2*platform_q2*r*s_68*sin(c1_head_angle)/s_1^2
/// s_344 = r*platform_q1_dot*cos(c1_head_angle)/s_1
/// s_345 = platform_q1*r*s_11*cos(c1_head_angle)/s_1^2
/// s_346 = s_344 - 2*s_345 - 2*r*s_4*platform_q2_dot*cos(c1_head_angle)/s_1^2
///     - 2*platform_q2*r*s_70*cos(c1_head_angle)/s_1^2
///     + 8*platform_q2*r*s_4*s_11*cos(c1_head_angle)/s_1^3
///     + 2*r*s_5*platform_q2_dot*sin(c1_head_angle)/s_1^2
///     - 8*platform_q2*r*s_5*s_11*sin(c1_head_angle)/s_1^3
///     + 4*platform_q2*r*s_71*sin(c1_head_angle)/s_1^2
/// s_347 = r*platform_q0_dot*cos(c1_head_angle)/s_1
/// s_348 = platform_q0*r*s_11*cos(c1_head_angle)/s_1^2
/// s_349 = s_323 - 2*s_324 - 2*r*s_6*platform_q2_dot*cos(c1_head_angle)/s_1^2
///     + 8*platform_q2*r*s_6*s_11*cos(c1_head_angle)/s_1^3
///     + 2*platform_q2*r*s_73*cos(c1_head_angle)/s_1^2 - s_347 + 2*s_348
///     - 2*r*s_7*platform_q2_dot*sin(c1_head_angle)/s_1^2
///     - 2*platform_q2*r*s_74*sin(c1_head_angle)/s_1^2
///     + 8*platform_q2*r*s_7*s_11*sin(c1_head_angle)/s_1^3
/// s_350 = s_309*s_319 + s_26*s_343 + s_311*s_320 + s_27*s_346 + s_313*s_321
///     + c1_on_platform_z*s_349
/// s_351 = s_339 - 2*s_340 + 2*r*s_107*cos(c1_head_angle)
///     + 2*r*s_3*platform_q3_dot*sin(c1_head_angle)/s_1^2
///     - 8*platform_q3*r*s_3*s_11*sin(c1_head_angle)/s_1^3
///     - 2*platform_q3*r*s_68*sin(c1_head_angle)/s_1^2
/// s_352 = s_347 - 2*s_348 - 2*r*s_4*platform_q3_dot*cos(c1_head_angle)/s_1^2
///     - 2*platform_q3*r*s_70*cos(c1_head_angle)/s_1^2
///     + 8*platform_q3*r*s_4*s_11*cos(c1_head_angle)/s_1^3 - 2*r*s_109*sin(c1_head_angle)
/// s_353 = s_335 - 2*s_336 + s_344 - 2*s_345 - 2*r*s_6*platform_q3_dot*cos(c1_head_angle)/s_1^2
///     + 8*platform_q3*r*s_6*s_11*cos(c1_head_angle)/s_1^3
///     + 2*platform_q3*r*s_73*cos(c1_head_angle)/s_1^2
///     - 2*r*s_7*platform_q3_dot*sin(c1_head_angle)/s_1^2
///     - 2*platform_q3*r*s_74*sin(c1_head_angle)/s_1^2
///     + 8*platform_q3*r*s_7*s_11*sin(c1_head_angle)/s_1^3
/// s_354 = s_315*s_319 + s_26*s_351 - s_316*s_320 - s_27*s_352 - s_317*s_321
///     - c1_on_platform_z*s_353
/// s_355 = platform_q3*r*sin(c2_head_angle)/s_1
/// s_356 = 2*platform_q0*r*s_2*cos(c2_head_angle)/s_1^2
///     - 2*platform_q0*r*s_3*sin(c2_head_angle)/s_1^2 - s_355
/// s_357 = platform_q3*r*cos(c2_head_angle)/s_1
/// s_358 = s_357 - 2*platform_q0*r*s_4*cos(c2_head_angle)/s_1^2
///     + 2*platform_q0*r*s_5*sin(c2_head_angle)/s_1^2
/// s_359 = platform_q2*r*cos(c2_head_angle)/s_1
/// s_360 = platform_q1*r*sin(c2_head_angle)/s_1
/// s_361 = 2*platform_q0*r*s_6*cos(c2_head_angle)/s_1^2 + s_359 - s_360
///     + 2*platform_q0*r*s_7*sin(c2_head_angle)/s_1^2
/// s_362 = s_29*s_356 + s_30*s_358 - c2_on_platform_z*s_361
/// s_363 = platform_q2*r*sin(c2_head_angle)/s_1
/// s_364 = 2*platform_q1*r*s_2*cos(c2_head_angle)/s_1^2 + s_363
///     - 2*platform_q1*r*s_3*sin(c2_head_angle)/s_1^2
/// s_365 = s_359 - 2*platform_q1*r*s_4*cos(c2_head_angle)/s_1^2 - 2*r*s_49*sin(c2_head_angle)
/// s_366 = platform_q0*r*sin(c2_head_angle)/s_1
/// s_367 = s_357 - 2*platform_q1*r*s_6*cos(c2_head_angle)/s_1^2 + s_366
///     - 2*platform_q1*r*s_7*sin(c2_head_angle)/s_1^2
/// s_368 = s_29*s_364 + s_30*s_365 + c2_on_platform_z*s_367
/// s_369 = s_360 - 2*r*s_54*cos(c2_head_angle) - 2*platform_q2*r*s_3*sin(c2_head_angle)/s_1^2
/// s_370 = platform_q1*r*cos(c2_head_angle)/s_1
/// s_371 = s_370 - 2*platform_q2*r*s_4*cos(c2_head_angle)/s_1^2
///     + 2*platform_q2*r*s_5*sin(c2_head_angle)/s_1^2
/// s_372 = platform_q0*r*cos(c2_head_angle)/s_1
/// s_373 = s_355 - 2*platform_q2*r*s_6*cos(c2_head_angle)/s_1^2 - s_372
///     - 2*platform_q2*r*s_7*sin(c2_head_angle)/s_1^2
/// s_374 = s_29*s_369 + s_30*s_371 + c2_on_platform_z*s_373
/// s_375 = s_366 + 2*r*s_61*cos(c2_head_angle) + 2*platform_q3*r*s_3*sin(c2_head_angle)/s_1^2
/// s_376 = s_372 - 2*platform_q3*r*s_4*cos(c2_head_angle)/s_1^2 - 2*r*s_63*sin(c2_head_angle)
/// s_377 = s_363 + s_370 - 2*platform_q3*r*s_6*cos(c2_head_angle)/s_1^2
///     - 2*platform_q3*r*s_7*sin(c2_head_angle)/s_1^2
/// s_378 = s_29*s_375 - s_30*s_376 - c2_on_platform_z*s_377
/// s_379 = platform_x_dot + 4*r*(s_2*s_11/s_1^2 - s_67/s_1)*cos(c2_head_angle)
///     - 4*r*s_3*s_11*sin(c2_head_angle)/s_1^2 - 2*r*s_68*sin(c2_head_angle)/s_1
/// s_380 = platform_y_dot + 2*r*s_70*cos(c2_head_angle)/s_1
///     - 4*r*s_4*s_11*cos(c2_head_angle)/s_1^2
///     + 4*r*(s_5*s_11/s_1^2 - s_71/s_1)*sin(c2_head_angle)
/// s_381 = platform_z_dot - 4*r*s_6*s_11*cos(c2_head_angle)/s_1^2
///     - 2*r*s_73*cos(c2_head_angle)/s_1 + 2*r*s_74*sin(c2_head_angle)/s_1
///     - 4*r*s_7*s_11*sin(c2_head_angle)/s_1^2
/// s_382 = s_29*s_379 + s_30*s_380 + c2_on_platform_z*s_381
/// s_383 = r*platform_q3_dot*sin(c2_head_angle)/s_1
/// s_384 = platform_q3*r*s_11*sin(c2_head_angle)/s_1^2
/// s_385 = 2*r*s_2*platform_q0_dot*cos(c2_head_angle)/s_1^2
///     - 8*platform_q0*r*s_2*s_11*cos(c2_head_angle)/s_1^3
///     + 4*platform_q0*r*s_67*cos(c2_head_angle)/s_1^2
///     - 2*r*s_3*platform_q0_dot*sin(c2_head_angle)/s_1^2
///     + 8*platform_q0*r*s_3*s_11*sin(c2_head_angle)/s_1^3
///     + 2*platform_q0*r*s_68*sin(c2_head_angle)/s_1^2 - s_383 + 2*s_384
/// s_386 = r*platform_q3_dot*cos(c2_head_angle)/s_1
/// s_387 = platform_q3*r*s_11*cos(c2_head_angle)/s_1^2
/// s_388 = s_386 - 2*s_387 - 2*r*s_4*platform_q0_dot*cos(c2_head_angle)/s_1^2
///     - 2*platform_q0*r*s_70*cos(c2_head_angle)/s_1^2
///     + 8*platform_q0*r*s_4*s_11*cos(c2_head_angle)/s_1^3
///     + 2*r*s_5*platform_q0_dot*sin(c2_head_angle)/s_1^2
///     - 8*platform_q0*r*s_5*s_11*sin(c2_head_angle)/s_1^3
///     + 4*platform_q0*r*s_71*sin(c2_head_angle)/s_1^2
/// s_389 = r*platform_q2_dot*cos(c2_head_angle)/s_1
/// s_390 = platform_q2*r*s_11*cos(c2_head_angle)/s_1^2
/// s_391 = r*platform_q1_dot*sin(c2_head_angle)/s_1
/// s_392 = platform_q1*r*s_11*sin(c2_head_angle)/s_1^2
/// s_393 = 2*r*s_6*platform_q0_dot*cos(c2_head_angle)/s_1^2
///     - 8*platform_q0*r*s_6*s_11*cos(c2_head_angle)/s_1^3
///     - 2*platform_q0*r*s_73*cos(c2_head_angle)/s_1^2 + s_389 - 2*s_390 - s_391 + 2*s_392
///     + 2*r*s_7*platform_q0_dot*sin(c2_head_angle)/s_1^2
///     + 2*platform_q0*r*s_74*sin(c2_head_angle)/s_1^2
///     - 8*platform_q0*r*s_7*s_11*sin(c2_head_angle)/s_1^3
/// s_394 = s_356*s_379 + s_29*s_385 + s_358*s_380 + s_30*s_388 - s_361*s_381
///     - c2_on_platform_z*s_393
/// s_395 = r*platform_q2_dot*sin(c2_head_angle)/s_1
/// s_396 = platform_q2*r*s_11*sin(c2_head_angle)/s_1^2
/// s_397 = 2*r*s_2*platform_q1_dot*cos(c2_head_angle)/s_1^2
///     - 8*platform_q1*r*s_2*s_11*cos(c2_head_angle)/s_1^3
///     + 4*platform_q1*r*s_67*cos(c2_head_angle)/s_1^2 + s_395 - 2*s_396
///     - 2*r*s_3*platform_q1_dot*sin(c2_head_angle)/s_1^2
///     + 8*platform_q1*r*s_3*s_11*sin(c2_head_angle)/s_1^3
///     + 2*platform_q1*r*s_68*sin(c2_head_angle)/s_1^2
/// s_398 = s_389 - 2*s_390 - 2*r*s_4*platform_q1_dot*cos(c2_head_angle)/s_1^2
///     - 2*platform_q1*r*s_70*cos(c2_head_angle)/s_1^2
///     + 8*platform_q1*r*s_4*s_11*cos(c2_head_angle)/s_1^3 - 2*r*s_92*sin(c2_head_angle)
/// s_399 = r*platform_q0_dot*sin(c2_head_angle)/s_1
/// s_400 = platform_q0*r*s_11*sin(c2_head_angle)/s_1^2
/// s_401 = s_386 - 2*s_387 - 2*r*s_6*platform_q1_dot*cos(c2_head_angle)/s_1^2
///     + 8*platform_q1*r*s_6*s_11*cos(c2_head_angle)/s_1^3
///     + 2*platform_q1*r*s_73*cos(c2_head_angle)/s_1^2 + s_399 - 2*s_400
///     - 2*r*s_7*platform_q1_dot*sin(c2_head_angle)/s_1^2
///     - 2*platform_q1*r*s_74*sin(c2_head_angle)/s_1^2
///     + 8*platform_q1*r*s_7*s_11*sin(c2_head_angle)/s_1^3
/// s_402 = s_364*s_379 + s_29*s_397 + s_365*s_380 + s_30*s_398 + s_367*s_381
///     + c2_on_platform_z*s_401
/// s_403 = s_391 - 2*s_392 - 2*r*s_98*cos(c2_head_angle)
///     - 2*r*s_3*platform_q2_dot*sin(c2_head_angle)/s_1^2
///     + 8*platform_q2*r*s_3*s_11*sin(c2_head_angle)/s_1^3
///     + 2*platform_q2*r*s_68*sin(c2_head_angle)/s_1^2
/// s_404 = r*platform_q1_dot*cos(c2_head_angle)/s_1
/// s_405 = platform_q1*r*s_11*cos(c2_head_angle)/s_1^2
/// s_406 = s_404 - 2*s_405 - 2*r*s_4*platform_q2_dot*cos(c2_head_angle)/s_1^2
///     - 2*platform_q2*r*s_70*cos(c2_head_angle)/s_1^2
///     + 8*platform_q2*r*s_4*s_11*cos(c2_head_angle)/s_1^3
///     + 2*r*s_5*platform_q2_dot*sin(c2_head_angle)/s_1^2
///     - 8*platform_q2*r*s_5*s_11*sin(c2_head_angle)/s_1^3
///     + 4*platform_q2*r*s_71*sin(c2_head_angle)/s_1^2
/// s_407 = r*platform_q0_dot*cos(c2_head_angle)/s_1
/// s_408 = platform_q0*r*s_11*cos(c2_head_angle)/s_1^2
/// s_409 = s_383 - 2*s_384 - 2*r*s_6*platform_q2_dot*cos(c2_head_angle)/s_1^2
///     + 8*platform_q2*r*s_6*s_11*cos(c2_head_angle)/s_1^3
///     + 2*platform_q2*r*s_73*cos(c2_head_angle)/s_1^2 - s_407 + 2*s_408
///     - 2*r*s_7*platform_q2_dot*sin(c2_head_angle)/s_1^2
///     - 2*platform_q2*r*s_74*sin(c2_head_angle)/s_1^2
///     + 8*platform_q2*r*s_7*s_11*sin(c2_head_angle)/s_1^3
/// s_410 = s_369*s_379 + s_29*s_403 + s_371*s_380 + s_30*s_406 + s_373*s_381
///     + c2_on_platform_z*s_409
/// s_411 = s_399 - 2*s_400 + 2*r*s_107*cos(c2_head_angle)
///     + 2*r*s_3*platform_q3_dot*sin(c2_head_angle)/s_1^2
///     - 8*platform_q3*r*s_3*s_11*sin(c2_head_angle)/s_1^3
///     - 2*platform_q3*r*s_68*sin(c2_head_angle)/s_1^2
/// s_412 = s_407 - 2*s_408 - 2*r*s_4*platform_q3_dot*cos(c2_head_angle)/s_1^2
///     - 2*platform_q3*r*s_70*cos(c2_head_angle)/s_1^2
///     + 8*platform_q3*r*s_4*s_11*cos(c2_head_angle)/s_1^3 - 2*r*s_109*sin(c2_head_angle)
/// s_413 = s_395 - 2*s_396 + s_404 - 2*s_405 - 2*r*s_6*platform_q3_dot*cos(c2_head_angle)/s_1^2
///     + 8*platform_q3*r*s_6*s_11*cos(c2_head_angle)/s_1^3
///     + 2*platform_q3*r*s_73*cos(c2_head_angle)/s_1^2
///     - 2*r*s_7*platform_q3_dot*sin(c2_head_angle)/s_1^2
///     - 2*platform_q3*r*s_74*sin(c2_head_angle)/s_1^2
///     + 8*platform_q3*r*s_7*s_11*sin(c2_head_angle)/s_1^3
/// s_414 = s_375*s_379 + s_29*s_411 - s_376*s_380 - s_30*s_412 - s_377*s_381
///     - c2_on_platform_z*s_413
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Stewart<S = ::core::primitive::f64> {
    /// In `kg`.
    pub m: S,
    /// Principal moments of inertia of the platform, in `kg*m^2`.
    pub A: S,
    /// In `kg*m^2`.
    pub C: S,
    /// Radius of the circle of the feet, in `m`.
    pub R: S,
    /// Radius of the circle of the heads, in `m`.
    pub r: S,
    /// Half of the angle between the feet of a pair, in `1`.
    pub foot: S,
    /// Half of the angle between the heads of a pair, in `1`.
    pub head: S,
    /// Length of the legs at rest, in `m`.
    pub L: S,
    /// How far all legs move together, in `m`.
    pub heave: S,
    /// How far neighbours move against each other, in `m`.
    pub sway: S,
    /// In `rad/s`.
    pub w: S,
    /// In `m/s^2`.
    pub g: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Stewart<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`Stewart`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct StewartCoordinates<S = ::core::primitive::f64> {
    /// In `m`.
    pub platform_x: S,
    /// In `m`.
    pub platform_y: S,
    /// In `m`.
    pub platform_z: S,
    /// In `1`.
    pub platform_q0: S,
    /// In `1`.
    pub platform_q1: S,
    /// In `1`.
    pub platform_q2: S,
    /// In `1`.
    pub platform_q3: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 7]> for StewartCoordinates<S> {
    fn from(values: [S; 7]) -> Self {
        Self {
            platform_x: values[0],
            platform_y: values[1],
            platform_z: values[2],
            platform_q0: values[3],
            platform_q1: values[4],
            platform_q2: values[5],
            platform_q3: values[6],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<StewartCoordinates<S>> for [S; 7] {
    fn from(record: StewartCoordinates<S>) -> Self {
        [
            record.platform_x,
            record.platform_y,
            record.platform_z,
            record.platform_q0,
            record.platform_q1,
            record.platform_q2,
            record.platform_q3,
        ]
    }
}
/// Outputs of [`Stewart`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct StewartOutputs<S = ::core::primitive::f64> {
    /// height of the platform, in `m`.
    pub height: S,
    /// lean of the platform, in `1`.
    pub lean: S,
    /// In `N`.
    pub force1: S,
    /// In `N`.
    pub force2: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for StewartOutputs<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            height: values[0],
            lean: values[1],
            force1: values[2],
            force2: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<StewartOutputs<S>> for [S; 4] {
    fn from(record: StewartOutputs<S>) -> Self {
        [record.height, record.lean, record.force1, record.force2]
    }
}
/// Rates of the outputs of [`Stewart`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct StewartOutputRates<S = ::core::primitive::f64> {
    /// Rate of `height`.
    pub height: S,
    /// Rate of `lean`.
    pub lean: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for StewartOutputRates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            height: values[0],
            lean: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<StewartOutputRates<S>> for [S; 2] {
    fn from(record: StewartOutputRates<S>) -> Self {
        [record.height, record.lean]
    }
}
/// What the equations of motion need of the parameters of [`Stewart`], from [`Stewart::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct StewartPrepared<S = ::core::primitive::f64> {
    m: S,
    A: S,
    k: S,
    k_2: S,
    k_3: S,
    k_4: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    k_9: S,
    k_10: S,
    k_11: S,
    k_12: S,
    k_13: S,
    k_14: S,
    k_15: S,
    k_16: S,
    k_17: S,
    k_18: S,
    k_19: S,
    k_20: S,
    k_21: S,
    k_22: S,
    k_23: S,
    k_24: S,
    k_25: S,
    k_26: S,
    k_27: S,
    k_28: S,
    k_29: S,
    k_30: S,
    k_31: S,
    k_32: S,
    k_33: S,
    k_34: S,
    k_35: S,
    k_36: S,
    k_37: S,
    k_38: S,
    k_39: S,
    k_40: S,
    k_41: S,
    k_42: S,
    k_43: S,
    k_44: S,
    minus_rhs_platform_z: S,
    k_45: S,
    k_46: S,
    k_47: S,
    w: S,
    k_48: S,
    k_49: S,
    k_50: S,
    k_51: S,
    k_52: S,
    k_53: S,
    k_54: S,
    k_55: S,
    k_56: S,
    k_57: S,
    k_58: S,
    k_59: S,
    k_60: S,
    k_61: S,
    k_62: S,
    k_63: S,
    k_64: S,
    k_65: S,
    k_66: S,
    k_67: S,
    k_68: S,
    k_69: S,
    k_70: S,
    k_71: S,
    k_72: S,
    k_73: S,
    k_74: S,
    inverse_platform_x: S,
    k_75: S,
    k_76: S,
    k_77: S,
    k_78: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Stewart<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 18 additions, 80 multiplications, 1 division, 12 sine-cosine pairs.
    #[inline]
    pub fn prepare(&self) -> StewartPrepared<S> {
        let w = S::from_f64(4.0) * self.A;
        let w_2 = S::from_f64(4.0) * self.C;
        let w_3 = S::from_f64(0.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        let a1_head_angle = w_3 - self.head;
        let w_4 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_4 - self.foot;
        let a2_head_angle = w_3 + self.head;
        let b1_foot_angle = w_4 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_5 = S::from_f64(1.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        let b2_foot_angle = w_5 - self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let c1_foot_angle = w_5 + self.foot;
        let w_6 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_6 - self.head;
        let w_7 = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI);
        let c2_foot_angle = w_7 - self.foot;
        let c2_head_angle = w_6 + self.head;
        let (
            [sin_foot,
            sin_a1_head_angle,
            sin_a2_foot_angle,
            sin_a2_head_angle,
            sin_b1_foot_angle,
            sin_b1_head_angle,
            sin_b2_foot_angle,
            sin_b2_head_angle,
            sin_c1_foot_angle,
            sin_c1_head_angle,
            sin_c2_foot_angle,
            sin_c2_head_angle,
            ],
            [cos_foot,
            cos_a1_head_angle,
            cos_a2_foot_angle,
            cos_a2_head_angle,
            cos_b1_foot_angle,
            cos_b1_head_angle,
            cos_b2_foot_angle,
            cos_b2_head_angle,
            cos_c1_foot_angle,
            cos_c1_head_angle,
            cos_c2_foot_angle,
            cos_c2_head_angle,
            ],
        ) = S::sin_cos_each([
            self.foot,
            a1_head_angle,
            a2_foot_angle,
            a2_head_angle,
            b1_foot_angle,
            b1_head_angle,
            b2_foot_angle,
            b2_head_angle,
            c1_foot_angle,
            c1_head_angle,
            c2_foot_angle,
            c2_head_angle,
        ]);
        let w_8 = S::from_f64(2.0) * self.r;
        let w_9 = self.m * self.g;
        let w_10 = S::from_f64(4.0) * self.r;
        let w_11 = self.r * S::from_f64(8.0);
        let w_squared = self.w * self.w;
        let w_12 = self.heave * w_squared;
        let w_13 = w_squared * self.sway;
        let inverse_m = S::from_f64(1.0) / self.m;
        let w_14 = self.heave * self.w;
        let w_15 = self.w * self.sway;
        StewartPrepared {
            m: self.m,
            A: self.A,
            k: w,
            k_2: w_2,
            k_3: S::from_f64(1.3333333333333333) * (self.A * S::from_f64(2.0) + self.C),
            k_4: w - w_2,
            k_5: w_2 - w,
            k_6: self.R * cos_foot,
            k_7: self.r * cos_a1_head_angle,
            k_8: sin_a1_head_angle * w_8,
            k_9: self.R * sin_foot,
            k_10: cos_a1_head_angle * w_8,
            k_11: self.r * sin_a1_head_angle,
            k_12: w_4,
            k_13: self.R * cos_a2_foot_angle,
            k_14: self.r * cos_a2_head_angle,
            k_15: w_8 * sin_a2_head_angle,
            k_16: self.R * sin_a2_foot_angle,
            k_17: w_8 * cos_a2_head_angle,
            k_18: self.r * sin_a2_head_angle,
            k_19: self.R * cos_b1_foot_angle,
            k_20: self.r * cos_b1_head_angle,
            k_21: w_8 * sin_b1_head_angle,
            k_22: self.R * sin_b1_foot_angle,
            k_23: w_8 * cos_b1_head_angle,
            k_24: self.r * sin_b1_head_angle,
            k_25: w_5,
            k_26: self.R * cos_b2_foot_angle,
            k_27: self.r * cos_b2_head_angle,
            k_28: w_8 * sin_b2_head_angle,
            k_29: self.R * sin_b2_foot_angle,
            k_30: w_8 * cos_b2_head_angle,
            k_31: self.r * sin_b2_head_angle,
            k_32: self.R * cos_c1_foot_angle,
            k_33: self.r * cos_c1_head_angle,
            k_34: w_8 * sin_c1_head_angle,
            k_35: self.R * sin_c1_foot_angle,
            k_36: w_8 * cos_c1_head_angle,
            k_37: self.r * sin_c1_head_angle,
            k_38: w_7,
            k_39: self.R * cos_c2_foot_angle,
            k_40: self.r * cos_c2_head_angle,
            k_41: w_8 * sin_c2_head_angle,
            k_42: self.R * sin_c2_foot_angle,
            k_43: w_8 * cos_c2_head_angle,
            k_44: self.r * sin_c2_head_angle,
            minus_rhs_platform_z: w_9,
            k_45: self.C - self.A,
            k_46: self.A - self.C,
            k_47: self.C * S::from_f64(8.0),
            w: self.w,
            k_48: cos_a1_head_angle * w_10,
            k_49: sin_a1_head_angle * w_10,
            k_50: cos_a1_head_angle * w_11,
            k_51: sin_a1_head_angle * w_11,
            k_52: w_12,
            k_53: w_13,
            k_54: w_12 + w_13,
            k_55: cos_a2_head_angle * w_10,
            k_56: sin_a2_head_angle * w_10,
            k_57: cos_a2_head_angle * w_11,
            k_58: sin_a2_head_angle * w_11,
            k_59: cos_b1_head_angle * w_10,
            k_60: sin_b1_head_angle * w_10,
            k_61: cos_b1_head_angle * w_11,
            k_62: sin_b1_head_angle * w_11,
            k_63: cos_b2_head_angle * w_10,
            k_64: sin_b2_head_angle * w_10,
            k_65: cos_b2_head_angle * w_11,
            k_66: sin_b2_head_angle * w_11,
            k_67: cos_c1_head_angle * w_10,
            k_68: sin_c1_head_angle * w_10,
            k_69: cos_c1_head_angle * w_11,
            k_70: sin_c1_head_angle * w_11,
            k_71: cos_c2_head_angle * w_10,
            k_72: sin_c2_head_angle * w_10,
            k_73: cos_c2_head_angle * w_11,
            k_74: sin_c2_head_angle * w_11,
            inverse_platform_x: inverse_m,
            k_75: w_9 * inverse_m,
            k_76: w_14,
            k_77: w_15,
            k_78: w_14 + w_15,
        }
    }
    /// Mass matrix `T_q' M T_q`, 7 x 7, symmetric, in SI units.
    ///
    /// Operations: 24 additions, 49 multiplications, 1 division.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 7]) -> [[S; 7]; 7] {
        let [_, _, _, platform_q0, platform_q1, platform_q2, platform_q3] = *q;
        let platform_q0_squared = platform_q0 * platform_q0;
        let platform_q1_squared = platform_q1 * platform_q1;
        let platform_q2_squared = platform_q2 * platform_q2;
        let platform_q3_squared = platform_q3 * platform_q3;
        let w = S::from_f64(1.0)
            / (platform_q0_squared + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_squared = w * w;
        let w_2 = S::from_f64(4.0) * self.A;
        let w_3 = w_2 * (platform_q1_squared + platform_q2_squared);
        let w_4 = S::from_f64(4.0) * self.C;
        let w_5 = S::from_f64(1.3333333333333333) * (self.A * S::from_f64(2.0) + self.C);
        let w_6 = w_5 - w_squared * w_2;
        let w_7 = w_2 - w_4;
        let w_8 = platform_q2 * platform_q3;
        let mass_platform_q1_platform_q0 = platform_q1 * platform_q0 * w_6
            + w_squared * w_7 * w_8;
        let w_9 = w_4 - w_2;
        let w_10 = platform_q0 * platform_q2;
        let mass_platform_q2_platform_q0 = w_squared
            * (platform_q1 * platform_q3 * w_9 - w_2 * w_10) + w_5 * w_10;
        let w_11 = w_5 - w_squared * w_4;
        let mass_platform_q3_platform_q0 = platform_q0 * platform_q3 * w_11;
        let w_12 = w_2 * (platform_q0_squared + platform_q3_squared);
        let mass_platform_q2_platform_q1 = platform_q1 * platform_q2 * w_11;
        let mass_platform_q3_platform_q1 = platform_q1 * platform_q3 * w_6
            + w_squared * w_9 * w_10;
        let mass_platform_q3_platform_q2 = w_squared
            * (platform_q1 * platform_q0 * w_7 - w_2 * w_8) + w_5 * w_8;
        [
            [
                self.m,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                self.m,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                self.m,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                w_squared * (w_3 + platform_q3_squared * w_4)
                    + platform_q0_squared * w_5,
                mass_platform_q1_platform_q0,
                mass_platform_q2_platform_q0,
                mass_platform_q3_platform_q0,
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_platform_q1_platform_q0,
                w_squared * (w_12 + platform_q2_squared * w_4)
                    + platform_q1_squared * w_5,
                mass_platform_q2_platform_q1,
                mass_platform_q3_platform_q1,
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_platform_q2_platform_q0,
                mass_platform_q2_platform_q1,
                w_squared * (w_12 + platform_q1_squared * w_4)
                    + platform_q2_squared * w_5,
                mass_platform_q3_platform_q2,
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_platform_q3_platform_q0,
                mass_platform_q3_platform_q1,
                mass_platform_q3_platform_q2,
                w_squared * (w_3 + platform_q0_squared * w_4) + platform_q3_squared * w_5,
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 7, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 35 additions, 72 multiplications, 1 division.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        let [_, _, _, platform_q0, platform_q1, platform_q2, platform_q3] = *q;
        let [_, _, _, platform_q0_dot, platform_q1_dot, platform_q2_dot, platform_q3_dot,
        ] = *qd;
        let w = S::from_f64(1.0)
            / (platform_q0 * platform_q0 + platform_q1 * platform_q1
                + platform_q2 * platform_q2 + platform_q3 * platform_q3);
        let w_squared = w * w;
        let w_2 = w * w_squared;
        let w_3 = platform_q0 * platform_q3_dot - platform_q3 * platform_q0_dot
            - platform_q1 * platform_q2_dot + platform_q2 * platform_q1_dot;
        let w_4 = platform_q0 * platform_q0_dot + platform_q1 * platform_q1_dot
            + platform_q2 * platform_q2_dot + platform_q3 * platform_q3_dot;
        let w_5 = S::from_f64(8.0) * self.C * w_3 * w_4;
        let w_6 = platform_q0 * platform_q2_dot - platform_q2 * platform_q0_dot
            - platform_q3 * platform_q1_dot + platform_q1 * platform_q3_dot;
        let w_7 = platform_q0 * platform_q1_dot - platform_q1 * platform_q0_dot
            - platform_q2 * platform_q3_dot + platform_q3 * platform_q2_dot;
        let w_8 = self.A * w_4;
        let w_9 = w_squared * (w_6 * w_3 * (self.C - self.A) - w_7 * w_8);
        let w_10 = w_squared * (w_3 * w_7 * (self.A - self.C) - w_6 * w_8);
        let w_11 = platform_q0_dot * platform_q0_dot + platform_q1_dot * platform_q1_dot
            + platform_q2_dot * platform_q2_dot + platform_q3_dot * platform_q3_dot;
        let w_12 = S::from_f64(1.3333333333333333)
            * (self.A * S::from_f64(2.0) + self.C);
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            platform_q3 * w_2 * w_5
                - S::from_f64(8.0) * w * (platform_q1 * w_9 + platform_q2 * w_10)
                + platform_q0 * w_11 * w_12,
            S::from_f64(8.0) * w * (platform_q0 * w_9 - platform_q3 * w_10)
                - platform_q2 * w_2 * w_5 + platform_q1 * w_11 * w_12,
            S::from_f64(8.0) * w * (platform_q3 * w_9 + platform_q0 * w_10)
                + platform_q1 * w_2 * w_5 + platform_q2 * w_11 * w_12,
            S::from_f64(8.0) * w * (platform_q1 * w_10 - platform_q2 * w_9)
                - platform_q0 * w_2 * w_5 + platform_q3 * w_11 * w_12,
        ]
    }
    /// Generalised forces `T_q' F`, 7: joules per unit of each coordinate.
    ///
    /// Operations: 1 addition, 1 multiplication.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            -(self.m * self.g),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
        ]
    }
    /// Constraints `C`, 7, in SI units; zero throughout the motion.
    ///
    /// Operations: 107 additions, 124 multiplications, 1 division, 16 sine-cosine pairs, 6 square roots.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 7]) -> [S; 7] {
        let [platform_x, platform_y, platform_z, platform_q0, platform_q1, platform_q2,
        platform_q3] = *q;
        let platform_q0_squared = platform_q0 * platform_q0;
        let platform_q1_squared = platform_q1 * platform_q1;
        let platform_q2_squared = platform_q2 * platform_q2;
        let platform_q3_squared = platform_q3 * platform_q3;
        let w = S::from_f64(0.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        let a1_head_angle = w - self.head;
        let w_2 = t * self.w;
        let w_3 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_3 - self.foot;
        let a2_head_angle = w + self.head;
        let b1_foot_angle = w_3 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_4 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333);
        let b2_foot_angle = w_4 - self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let c1_foot_angle = w_4 + self.foot;
        let w_5 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_5 - self.head;
        let w_6 = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI);
        let c2_foot_angle = w_6 - self.foot;
        let c2_head_angle = w_5 + self.head;
        let (
            [sin_foot,
            sin_a1_head_angle,
            sin_w_2,
            sin_a2_foot_angle,
            sin_a2_head_angle,
            w_7,
            sin_b1_foot_angle,
            sin_b1_head_angle,
            sin_b2_foot_angle,
            sin_b2_head_angle,
            w_8,
            sin_c1_foot_angle,
            sin_c1_head_angle,
            sin_c2_foot_angle,
            sin_c2_head_angle,
            w_9,
            ],
            [cos_foot,
            cos_a1_head_angle,
            _,
            cos_a2_foot_angle,
            cos_a2_head_angle,
            _,
            cos_b1_foot_angle,
            cos_b1_head_angle,
            cos_b2_foot_angle,
            cos_b2_head_angle,
            _,
            cos_c1_foot_angle,
            cos_c1_head_angle,
            cos_c2_foot_angle,
            cos_c2_head_angle,
            _,
            ],
        ) = S::sin_cos_each([
            self.foot,
            a1_head_angle,
            w_2,
            a2_foot_angle,
            a2_head_angle,
            w_3 + w_2,
            b1_foot_angle,
            b1_head_angle,
            b2_foot_angle,
            b2_head_angle,
            w_4 + w_2,
            c1_foot_angle,
            c1_head_angle,
            c2_foot_angle,
            c2_head_angle,
            w_6 + w_2,
        ]);
        let w_10 = S::from_f64(1.0)
            / (platform_q0_squared + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_11 = S::from_f64(2.0) * w_10 * (platform_q2_squared + platform_q3_squared)
            - S::from_f64(1.0);
        let w_12 = self.r * S::from_f64(2.0);
        let w_13 = sin_a1_head_angle * w_12;
        let w_14 = platform_q1 * platform_q2;
        let w_15 = platform_q0 * platform_q3;
        let w_16 = w_10 * (w_14 - w_15);
        let w_17 = platform_x - self.R * cos_foot - w_11 * self.r * cos_a1_head_angle
            + w_13 * w_16;
        let w_18 = cos_a1_head_angle * w_12;
        let w_19 = w_10 * (w_14 + w_15);
        let w_20 = S::from_f64(2.0) * w_10 * (platform_q1_squared + platform_q3_squared)
            - S::from_f64(1.0);
        let w_21 = platform_y - self.R * sin_foot + w_18 * w_19
            - w_20 * self.r * sin_a1_head_angle;
        let w_22 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_23 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let a1_on_platform_z = w_10 * (w_18 * w_22 + w_13 * w_23) + platform_z;
        let w_24 = w_12 * sin_a2_head_angle;
        let w_25 = platform_x - self.R * cos_a2_foot_angle
            - w_11 * self.r * cos_a2_head_angle + w_16 * w_24;
        let w_26 = w_12 * cos_a2_head_angle;
        let w_27 = platform_y - self.R * sin_a2_foot_angle + w_19 * w_26
            - w_20 * self.r * sin_a2_head_angle;
        let a2_on_platform_z = w_10 * (w_22 * w_26 + w_23 * w_24) + platform_z;
        let w_28 = self.heave * sin_w_2;
        let w_29 = self.sway * w_7;
        let w_30 = w_12 * sin_b1_head_angle;
        let w_31 = platform_x - self.R * cos_b1_foot_angle
            - w_11 * self.r * cos_b1_head_angle + w_16 * w_30;
        let w_32 = w_12 * cos_b1_head_angle;
        let w_33 = platform_y - self.R * sin_b1_foot_angle + w_19 * w_32
            - w_20 * self.r * sin_b1_head_angle;
        let b1_on_platform_z = w_10 * (w_22 * w_32 + w_23 * w_30) + platform_z;
        let w_34 = w_12 * sin_b2_head_angle;
        let w_35 = platform_x - self.R * cos_b2_foot_angle
            - w_11 * self.r * cos_b2_head_angle + w_16 * w_34;
        let w_36 = w_12 * cos_b2_head_angle;
        let w_37 = platform_y - self.R * sin_b2_foot_angle + w_19 * w_36
            - w_20 * self.r * sin_b2_head_angle;
        let b2_on_platform_z = w_10 * (w_22 * w_36 + w_23 * w_34) + platform_z;
        let w_38 = self.sway * w_8;
        let w_39 = w_12 * sin_c1_head_angle;
        let w_40 = platform_x - self.R * cos_c1_foot_angle
            - w_11 * self.r * cos_c1_head_angle + w_16 * w_39;
        let w_41 = w_12 * cos_c1_head_angle;
        let w_42 = platform_y - self.R * sin_c1_foot_angle + w_19 * w_41
            - w_20 * self.r * sin_c1_head_angle;
        let c1_on_platform_z = w_10 * (w_22 * w_41 + w_23 * w_39) + platform_z;
        let w_43 = w_12 * sin_c2_head_angle;
        let w_44 = platform_x - self.R * cos_c2_foot_angle
            - w_11 * self.r * cos_c2_head_angle + w_16 * w_43;
        let w_45 = w_12 * cos_c2_head_angle;
        let w_46 = platform_y - self.R * sin_c2_foot_angle + w_19 * w_45
            - w_20 * self.r * sin_c2_head_angle;
        let c2_on_platform_z = w_10 * (w_22 * w_45 + w_23 * w_43) + platform_z;
        [
            platform_q0_squared + platform_q1_squared + platform_q2_squared
                + platform_q3_squared - S::from_f64(1.0),
            (w_17 * w_17 + w_21 * w_21 + a1_on_platform_z * a1_on_platform_z).sqrt()
                - self.L - sin_w_2 * (self.heave + self.sway),
            (w_25 * w_25 + w_27 * w_27 + a2_on_platform_z * a2_on_platform_z).sqrt()
                - self.L - w_28 + w_29,
            (w_31 * w_31 + w_33 * w_33 + b1_on_platform_z * b1_on_platform_z).sqrt()
                - self.L - w_28 - w_29,
            (w_35 * w_35 + w_37 * w_37 + b2_on_platform_z * b2_on_platform_z).sqrt()
                - self.L - w_28 + w_38,
            (w_40 * w_40 + w_42 * w_42 + c1_on_platform_z * c1_on_platform_z).sqrt()
                - self.L - w_28 - w_38,
            (w_44 * w_44 + w_46 * w_46 + c2_on_platform_z * c2_on_platform_z).sqrt()
                - self.L - w_28 + self.sway * w_9,
        ]
    }
    /// The sum of the magnitudes of the terms of `C`, 7, in SI units: what its rounding is relative to.
    ///
    /// Operations: 123 additions, 124 multiplications, 1 division, 16 sine-cosine pairs, 6 square roots.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 7]) -> [S; 7] {
        let [platform_x, platform_y, platform_z, platform_q0, platform_q1, platform_q2,
        platform_q3] = *q;
        let platform_q0_squared = platform_q0 * platform_q0;
        let platform_q1_squared = platform_q1 * platform_q1;
        let platform_q2_squared = platform_q2 * platform_q2;
        let platform_q3_squared = platform_q3 * platform_q3;
        let abs_L = self.L.abs();
        let w = S::from_f64(0.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        let a1_head_angle = w - self.head;
        let w_2 = t * self.w;
        let w_3 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_3 - self.foot;
        let a2_head_angle = w + self.head;
        let b1_foot_angle = w_3 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_4 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333);
        let b2_foot_angle = w_4 - self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let c1_foot_angle = w_4 + self.foot;
        let w_5 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_5 - self.head;
        let w_6 = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI);
        let c2_foot_angle = w_6 - self.foot;
        let c2_head_angle = w_5 + self.head;
        let (
            [sin_foot,
            sin_a1_head_angle,
            sin_w_2,
            sin_a2_foot_angle,
            sin_a2_head_angle,
            w_7,
            sin_b1_foot_angle,
            sin_b1_head_angle,
            sin_b2_foot_angle,
            sin_b2_head_angle,
            w_8,
            sin_c1_foot_angle,
            sin_c1_head_angle,
            sin_c2_foot_angle,
            sin_c2_head_angle,
            w_9,
            ],
            [cos_foot,
            cos_a1_head_angle,
            _,
            cos_a2_foot_angle,
            cos_a2_head_angle,
            _,
            cos_b1_foot_angle,
            cos_b1_head_angle,
            cos_b2_foot_angle,
            cos_b2_head_angle,
            _,
            cos_c1_foot_angle,
            cos_c1_head_angle,
            cos_c2_foot_angle,
            cos_c2_head_angle,
            _,
            ],
        ) = S::sin_cos_each([
            self.foot,
            a1_head_angle,
            w_2,
            a2_foot_angle,
            a2_head_angle,
            w_3 + w_2,
            b1_foot_angle,
            b1_head_angle,
            b2_foot_angle,
            b2_head_angle,
            w_4 + w_2,
            c1_foot_angle,
            c1_head_angle,
            c2_foot_angle,
            c2_head_angle,
            w_6 + w_2,
        ]);
        let w_10 = S::from_f64(1.0)
            / (platform_q0_squared + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_11 = S::from_f64(2.0) * w_10 * (platform_q2_squared + platform_q3_squared)
            - S::from_f64(1.0);
        let w_12 = self.r * S::from_f64(2.0);
        let w_13 = sin_a1_head_angle * w_12;
        let w_14 = platform_q1 * platform_q2;
        let w_15 = platform_q0 * platform_q3;
        let w_16 = w_10 * (w_14 - w_15);
        let w_17 = platform_x - self.R * cos_foot - w_11 * self.r * cos_a1_head_angle
            + w_13 * w_16;
        let w_18 = cos_a1_head_angle * w_12;
        let w_19 = w_10 * (w_14 + w_15);
        let w_20 = S::from_f64(2.0) * w_10 * (platform_q1_squared + platform_q3_squared)
            - S::from_f64(1.0);
        let w_21 = platform_y - self.R * sin_foot + w_18 * w_19
            - w_20 * self.r * sin_a1_head_angle;
        let w_22 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_23 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let a1_on_platform_z = w_10 * (w_18 * w_22 + w_13 * w_23) + platform_z;
        let w_24 = (self.heave * sin_w_2).abs();
        let w_25 = w_12 * sin_a2_head_angle;
        let w_26 = platform_x - self.R * cos_a2_foot_angle
            - w_11 * self.r * cos_a2_head_angle + w_16 * w_25;
        let w_27 = w_12 * cos_a2_head_angle;
        let w_28 = platform_y - self.R * sin_a2_foot_angle + w_19 * w_27
            - w_20 * self.r * sin_a2_head_angle;
        let a2_on_platform_z = w_10 * (w_22 * w_27 + w_23 * w_25) + platform_z;
        let w_29 = (self.sway * w_7).abs();
        let w_30 = w_12 * sin_b1_head_angle;
        let w_31 = platform_x - self.R * cos_b1_foot_angle
            - w_11 * self.r * cos_b1_head_angle + w_16 * w_30;
        let w_32 = w_12 * cos_b1_head_angle;
        let w_33 = platform_y - self.R * sin_b1_foot_angle + w_19 * w_32
            - w_20 * self.r * sin_b1_head_angle;
        let b1_on_platform_z = w_10 * (w_22 * w_32 + w_23 * w_30) + platform_z;
        let w_34 = w_12 * sin_b2_head_angle;
        let w_35 = platform_x - self.R * cos_b2_foot_angle
            - w_11 * self.r * cos_b2_head_angle + w_16 * w_34;
        let w_36 = w_12 * cos_b2_head_angle;
        let w_37 = platform_y - self.R * sin_b2_foot_angle + w_19 * w_36
            - w_20 * self.r * sin_b2_head_angle;
        let b2_on_platform_z = w_10 * (w_22 * w_36 + w_23 * w_34) + platform_z;
        let w_38 = (self.sway * w_8).abs();
        let w_39 = w_12 * sin_c1_head_angle;
        let w_40 = platform_x - self.R * cos_c1_foot_angle
            - w_11 * self.r * cos_c1_head_angle + w_16 * w_39;
        let w_41 = w_12 * cos_c1_head_angle;
        let w_42 = platform_y - self.R * sin_c1_foot_angle + w_19 * w_41
            - w_20 * self.r * sin_c1_head_angle;
        let c1_on_platform_z = w_10 * (w_22 * w_41 + w_23 * w_39) + platform_z;
        let w_43 = w_12 * sin_c2_head_angle;
        let w_44 = platform_x - self.R * cos_c2_foot_angle
            - w_11 * self.r * cos_c2_head_angle + w_16 * w_43;
        let w_45 = w_12 * cos_c2_head_angle;
        let w_46 = platform_y - self.R * sin_c2_foot_angle + w_19 * w_45
            - w_20 * self.r * sin_c2_head_angle;
        let c2_on_platform_z = w_10 * (w_22 * w_45 + w_23 * w_43) + platform_z;
        [
            platform_q0_squared.abs() + platform_q1_squared.abs()
                + platform_q2_squared.abs() + platform_q3_squared.abs()
                + S::from_f64(1.0),
            abs_L
                + (w_17 * w_17 + w_21 * w_21 + a1_on_platform_z * a1_on_platform_z)
                    .sqrt()
                    .abs() + w_24 + (sin_w_2 * self.sway).abs(),
            abs_L + w_24
                + (w_26 * w_26 + w_28 * w_28 + a2_on_platform_z * a2_on_platform_z)
                    .sqrt()
                    .abs() + w_29,
            abs_L + w_24 + w_29
                + (w_31 * w_31 + w_33 * w_33 + b1_on_platform_z * b1_on_platform_z)
                    .sqrt()
                    .abs(),
            abs_L + w_24
                + (w_35 * w_35 + w_37 * w_37 + b2_on_platform_z * b2_on_platform_z)
                    .sqrt()
                    .abs() + w_38,
            abs_L + w_24 + w_38
                + (w_40 * w_40 + w_42 * w_42 + c1_on_platform_z * c1_on_platform_z)
                    .sqrt()
                    .abs(),
            abs_L + w_24
                + (w_44 * w_44 + w_46 * w_46 + c2_on_platform_z * c2_on_platform_z)
                    .sqrt()
                    .abs() + (self.sway * w_9).abs(),
        ]
    }
    /// Constraint Jacobian `C_q`, 7 x 7: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 270 additions, 536 multiplications, 43 divisions, 12 sine-cosine pairs, 6 square roots.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 7]) -> [[S; 7]; 7] {
        let [platform_x, platform_y, platform_z, platform_q0, platform_q1, platform_q2,
        platform_q3] = *q;
        let w = S::from_f64(0.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        let a1_head_angle = w - self.head;
        let w_2 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_2 - self.foot;
        let a2_head_angle = w + self.head;
        let b1_foot_angle = w_2 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_3 = S::from_f64(1.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        let b2_foot_angle = w_3 - self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let c1_foot_angle = w_3 + self.foot;
        let w_4 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_4 - self.head;
        let c2_foot_angle = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI)
            - self.foot;
        let c2_head_angle = w_4 + self.head;
        let (
            [sin_foot,
            sin_a1_head_angle,
            sin_a2_foot_angle,
            sin_a2_head_angle,
            sin_b1_foot_angle,
            sin_b1_head_angle,
            sin_b2_foot_angle,
            sin_b2_head_angle,
            sin_c1_foot_angle,
            sin_c1_head_angle,
            sin_c2_foot_angle,
            sin_c2_head_angle,
            ],
            [cos_foot,
            cos_a1_head_angle,
            cos_a2_foot_angle,
            cos_a2_head_angle,
            cos_b1_foot_angle,
            cos_b1_head_angle,
            cos_b2_foot_angle,
            cos_b2_head_angle,
            cos_c1_foot_angle,
            cos_c1_head_angle,
            cos_c2_foot_angle,
            cos_c2_head_angle,
            ],
        ) = S::sin_cos_each([
            self.foot,
            a1_head_angle,
            a2_foot_angle,
            a2_head_angle,
            b1_foot_angle,
            b1_head_angle,
            b2_foot_angle,
            b2_head_angle,
            c1_foot_angle,
            c1_head_angle,
            c2_foot_angle,
            c2_head_angle,
        ]);
        let platform_q1_squared = platform_q1 * platform_q1;
        let platform_q2_squared = platform_q2 * platform_q2;
        let platform_q3_squared = platform_q3 * platform_q3;
        let w_5 = S::from_f64(1.0)
            / (platform_q0 * platform_q0 + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_6 = platform_q2_squared + platform_q3_squared;
        let w_7 = w_5 * S::from_f64(2.0) * w_6 - S::from_f64(1.0);
        let w_8 = self.r * cos_a1_head_angle;
        let w_9 = S::from_f64(2.0) * self.r;
        let w_10 = sin_a1_head_angle * w_9;
        let w_11 = platform_q1 * platform_q2;
        let w_12 = platform_q0 * platform_q3;
        let w_13 = w_11 - w_12;
        let w_14 = w_5 * w_13;
        let w_15 = platform_x - self.R * cos_foot - w_7 * w_8 + w_10 * w_14;
        let w_16 = cos_a1_head_angle * w_9;
        let w_17 = w_11 + w_12;
        let w_18 = w_5 * w_17;
        let w_19 = platform_q1_squared + platform_q3_squared;
        let w_20 = w_5 * S::from_f64(2.0) * w_19 - S::from_f64(1.0);
        let w_21 = self.r * sin_a1_head_angle;
        let w_22 = platform_y - self.R * sin_foot + w_16 * w_18 - w_20 * w_21;
        let w_23 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_24 = platform_q2 * platform_q3 + platform_q1 * platform_q0;
        let w_25 = w_16 * w_23 + w_10 * w_24;
        let a1_on_platform_z = w_5 * w_25 + platform_z;
        let w_26 = w_15 * w_15 + w_22 * w_22 + a1_on_platform_z * a1_on_platform_z;
        let sqrt_w_26 = w_26.sqrt();
        let w_5_squared = w_5 * w_5;
        let w_27 = w_5_squared * (w_6 * w_16 - w_13 * w_10);
        let w_28 = platform_q3 * w_5;
        let w_29 = w_5_squared * (w_10 * w_19 - w_17 * w_16);
        let w_30 = w_5_squared * w_25;
        let w_31 = a1_on_platform_z
            * (platform_q0 * w_30 + w_5 * (platform_q2 * w_8 - platform_q1 * w_21));
        let w_32 = platform_q2 * w_5;
        let w_33 = w_17 * platform_q1 * w_5_squared;
        let w_34 = w_5 - w_5_squared * w_19;
        let w_35 = platform_q1 * w_34;
        let w_36 = a1_on_platform_z
            * (w_5 * (platform_q3 * w_8 + platform_q0 * w_21) - platform_q1 * w_30);
        let w_37 = platform_q1 * w_5;
        let w_38 = w_5 - w_5_squared * w_6;
        let w_39 = platform_q2 * w_38;
        let w_40 = w_13 * platform_q2 * w_5_squared;
        let w_41 = a1_on_platform_z
            * (w_5 * (platform_q3 * w_21 - platform_q0 * w_8) - platform_q2 * w_30);
        let w_42 = platform_q0 * w_5;
        let w_43 = platform_q3 * w_38;
        let w_44 = platform_q3 * w_5_squared;
        let w_45 = w_13 * w_44;
        let w_46 = w_17 * w_44;
        let w_47 = platform_q3 * w_34;
        let w_48 = a1_on_platform_z
            * (w_5 * (platform_q2 * w_21 + platform_q1 * w_8) - platform_q3 * w_30);
        let w_49 = S::from_f64(2.0) * sqrt_w_26
            * (w_15 * (w_21 * w_42 + w_16 * w_43 + w_10 * w_45)
                - w_22 * (w_8 * w_42 - w_16 * w_46 - w_10 * w_47) - w_48);
        let w_50 = self.r * cos_a2_head_angle;
        let w_51 = w_9 * sin_a2_head_angle;
        let w_52 = platform_x - self.R * cos_a2_foot_angle - w_7 * w_50 + w_14 * w_51;
        let w_53 = w_9 * cos_a2_head_angle;
        let w_54 = self.r * sin_a2_head_angle;
        let w_55 = platform_y - self.R * sin_a2_foot_angle + w_18 * w_53 - w_20 * w_54;
        let w_56 = w_23 * w_53 + w_24 * w_51;
        let a2_on_platform_z = w_5 * w_56 + platform_z;
        let w_57 = w_52 * w_52 + w_55 * w_55 + a2_on_platform_z * a2_on_platform_z;
        let sqrt_w_57 = w_57.sqrt();
        let w_58 = w_5_squared * (w_6 * w_53 - w_13 * w_51);
        let w_59 = w_5_squared * (w_19 * w_51 - w_17 * w_53);
        let w_60 = w_5_squared * w_56;
        let w_61 = a2_on_platform_z
            * (platform_q0 * w_60 + w_5 * (platform_q2 * w_50 - platform_q1 * w_54));
        let w_62 = a2_on_platform_z
            * (w_5 * (platform_q3 * w_50 + platform_q0 * w_54) - platform_q1 * w_60);
        let w_63 = a2_on_platform_z
            * (w_5 * (platform_q3 * w_54 - platform_q0 * w_50) - platform_q2 * w_60);
        let w_64 = a2_on_platform_z
            * (w_5 * (platform_q2 * w_54 + platform_q1 * w_50) - platform_q3 * w_60);
        let w_65 = S::from_f64(2.0) * sqrt_w_57
            * (w_52 * (w_42 * w_54 + w_43 * w_53 + w_45 * w_51)
                - w_55 * (w_42 * w_50 - w_46 * w_53 - w_47 * w_51) - w_64);
        let w_66 = self.r * cos_b1_head_angle;
        let w_67 = w_9 * sin_b1_head_angle;
        let w_68 = platform_x - self.R * cos_b1_foot_angle - w_7 * w_66 + w_14 * w_67;
        let w_69 = w_9 * cos_b1_head_angle;
        let w_70 = self.r * sin_b1_head_angle;
        let w_71 = platform_y - self.R * sin_b1_foot_angle + w_18 * w_69 - w_20 * w_70;
        let w_72 = w_23 * w_69 + w_24 * w_67;
        let b1_on_platform_z = w_5 * w_72 + platform_z;
        let w_73 = w_68 * w_68 + w_71 * w_71 + b1_on_platform_z * b1_on_platform_z;
        let sqrt_w_73 = w_73.sqrt();
        let w_74 = w_5_squared * (w_6 * w_69 - w_13 * w_67);
        let w_75 = w_5_squared * (w_19 * w_67 - w_17 * w_69);
        let w_76 = w_5_squared * w_72;
        let w_77 = b1_on_platform_z
            * (platform_q0 * w_76 + w_5 * (platform_q2 * w_66 - platform_q1 * w_70));
        let w_78 = b1_on_platform_z
            * (w_5 * (platform_q3 * w_66 + platform_q0 * w_70) - platform_q1 * w_76);
        let w_79 = b1_on_platform_z
            * (w_5 * (platform_q3 * w_70 - platform_q0 * w_66) - platform_q2 * w_76);
        let w_80 = b1_on_platform_z
            * (w_5 * (platform_q2 * w_70 + platform_q1 * w_66) - platform_q3 * w_76);
        let w_81 = S::from_f64(2.0) * sqrt_w_73
            * (w_68 * (w_42 * w_70 + w_43 * w_69 + w_45 * w_67)
                - w_71 * (w_42 * w_66 - w_46 * w_69 - w_47 * w_67) - w_80);
        let w_82 = self.r * cos_b2_head_angle;
        let w_83 = w_9 * sin_b2_head_angle;
        let w_84 = platform_x - self.R * cos_b2_foot_angle - w_7 * w_82 + w_14 * w_83;
        let w_85 = w_9 * cos_b2_head_angle;
        let w_86 = self.r * sin_b2_head_angle;
        let w_87 = platform_y - self.R * sin_b2_foot_angle + w_18 * w_85 - w_20 * w_86;
        let w_88 = w_23 * w_85 + w_24 * w_83;
        let b2_on_platform_z = w_5 * w_88 + platform_z;
        let w_89 = w_84 * w_84 + w_87 * w_87 + b2_on_platform_z * b2_on_platform_z;
        let sqrt_w_89 = w_89.sqrt();
        let w_90 = w_5_squared * (w_6 * w_85 - w_13 * w_83);
        let w_91 = w_5_squared * (w_19 * w_83 - w_17 * w_85);
        let w_92 = w_5_squared * w_88;
        let w_93 = b2_on_platform_z
            * (platform_q0 * w_92 + w_5 * (platform_q2 * w_82 - platform_q1 * w_86));
        let w_94 = b2_on_platform_z
            * (w_5 * (platform_q3 * w_82 + platform_q0 * w_86) - platform_q1 * w_92);
        let w_95 = b2_on_platform_z
            * (w_5 * (platform_q3 * w_86 - platform_q0 * w_82) - platform_q2 * w_92);
        let w_96 = b2_on_platform_z
            * (w_5 * (platform_q2 * w_86 + platform_q1 * w_82) - platform_q3 * w_92);
        let w_97 = S::from_f64(2.0) * sqrt_w_89
            * (w_84 * (w_42 * w_86 + w_43 * w_85 + w_45 * w_83)
                - w_87 * (w_42 * w_82 - w_46 * w_85 - w_47 * w_83) - w_96);
        let w_98 = self.r * cos_c1_head_angle;
        let w_99 = w_9 * sin_c1_head_angle;
        let w_100 = platform_x - self.R * cos_c1_foot_angle - w_7 * w_98 + w_14 * w_99;
        let w_101 = w_9 * cos_c1_head_angle;
        let w_102 = self.r * sin_c1_head_angle;
        let w_103 = platform_y - self.R * sin_c1_foot_angle + w_18 * w_101
            - w_20 * w_102;
        let w_104 = w_23 * w_101 + w_24 * w_99;
        let c1_on_platform_z = w_5 * w_104 + platform_z;
        let w_105 = w_100 * w_100 + w_103 * w_103 + c1_on_platform_z * c1_on_platform_z;
        let sqrt_w_105 = w_105.sqrt();
        let w_106 = w_5_squared * (w_6 * w_101 - w_13 * w_99);
        let w_107 = w_5_squared * (w_19 * w_99 - w_17 * w_101);
        let w_108 = w_5_squared * w_104;
        let w_109 = c1_on_platform_z
            * (platform_q0 * w_108 + w_5 * (platform_q2 * w_98 - platform_q1 * w_102));
        let w_110 = c1_on_platform_z
            * (w_5 * (platform_q3 * w_98 + platform_q0 * w_102) - platform_q1 * w_108);
        let w_111 = c1_on_platform_z
            * (w_5 * (platform_q3 * w_102 - platform_q0 * w_98) - platform_q2 * w_108);
        let w_112 = c1_on_platform_z
            * (w_5 * (platform_q2 * w_102 + platform_q1 * w_98) - platform_q3 * w_108);
        let w_113 = S::from_f64(2.0) * sqrt_w_105
            * (w_100 * (w_42 * w_102 + w_43 * w_101 + w_45 * w_99)
                - w_103 * (w_42 * w_98 - w_46 * w_101 - w_47 * w_99) - w_112);
        let w_114 = self.r * cos_c2_head_angle;
        let w_115 = w_9 * sin_c2_head_angle;
        let w_116 = platform_x - self.R * cos_c2_foot_angle - w_7 * w_114 + w_14 * w_115;
        let w_117 = w_9 * cos_c2_head_angle;
        let w_118 = self.r * sin_c2_head_angle;
        let w_119 = platform_y - self.R * sin_c2_foot_angle + w_18 * w_117
            - w_20 * w_118;
        let w_120 = w_23 * w_117 + w_24 * w_115;
        let c2_on_platform_z = w_5 * w_120 + platform_z;
        let w_121 = w_116 * w_116 + w_119 * w_119 + c2_on_platform_z * c2_on_platform_z;
        let sqrt_w_121 = w_121.sqrt();
        let w_122 = w_5_squared * (w_6 * w_117 - w_13 * w_115);
        let w_123 = w_5_squared * (w_19 * w_115 - w_17 * w_117);
        let w_124 = w_5_squared * w_120;
        let w_125 = c2_on_platform_z
            * (platform_q0 * w_124 + w_5 * (platform_q2 * w_114 - platform_q1 * w_118));
        let w_126 = c2_on_platform_z
            * (w_5 * (platform_q3 * w_114 + platform_q0 * w_118) - platform_q1 * w_124);
        let w_127 = c2_on_platform_z
            * (w_5 * (platform_q3 * w_118 - platform_q0 * w_114) - platform_q2 * w_124);
        let w_128 = c2_on_platform_z
            * (w_5 * (platform_q2 * w_118 + platform_q1 * w_114) - platform_q3 * w_124);
        let w_129 = S::from_f64(2.0) * sqrt_w_121
            * (w_116 * (w_42 * w_118 + w_43 * w_117 + w_45 * w_115)
                - w_119 * (w_42 * w_114 - w_46 * w_117 - w_47 * w_115) - w_128);
        [
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                platform_q0 * S::from_f64(2.0),
                platform_q1 * S::from_f64(2.0),
                platform_q2 * S::from_f64(2.0),
                platform_q3 * S::from_f64(2.0),
            ],
            [
                w_15 * sqrt_w_26 / w_26,
                w_22 * sqrt_w_26 / w_26,
                a1_on_platform_z * sqrt_w_26 / w_26,
                S::from_f64(2.0) * sqrt_w_26
                    * (w_15 * (platform_q0 * w_27 - w_21 * w_28)
                        + w_22 * (platform_q0 * w_29 + w_8 * w_28) - w_31) / w_26,
                S::from_f64(2.0) * sqrt_w_26
                    * (w_15 * (platform_q1 * w_27 + w_21 * w_32)
                        + w_22 * (w_8 * w_32 - w_16 * w_33 - w_10 * w_35) + w_36) / w_26,
                S::from_f64(2.0) * sqrt_w_26
                    * (w_15 * (w_21 * w_37 - w_16 * w_39 - w_10 * w_40)
                        + w_22 * (platform_q2 * w_29 + w_8 * w_37) + w_41) / w_26,
                -(w_49 / w_26),
            ],
            [
                w_52 * sqrt_w_57 / w_57,
                w_55 * sqrt_w_57 / w_57,
                a2_on_platform_z * sqrt_w_57 / w_57,
                S::from_f64(2.0) * sqrt_w_57
                    * (w_52 * (platform_q0 * w_58 - w_28 * w_54)
                        + w_55 * (platform_q0 * w_59 + w_28 * w_50) - w_61) / w_57,
                S::from_f64(2.0) * sqrt_w_57
                    * (w_52 * (platform_q1 * w_58 + w_32 * w_54)
                        + w_55 * (w_32 * w_50 - w_33 * w_53 - w_35 * w_51) + w_62)
                    / w_57,
                S::from_f64(2.0) * sqrt_w_57
                    * (w_52 * (w_37 * w_54 - w_39 * w_53 - w_40 * w_51)
                        + w_55 * (platform_q2 * w_59 + w_37 * w_50) + w_63) / w_57,
                -(w_65 / w_57),
            ],
            [
                w_68 * sqrt_w_73 / w_73,
                w_71 * sqrt_w_73 / w_73,
                b1_on_platform_z * sqrt_w_73 / w_73,
                S::from_f64(2.0) * sqrt_w_73
                    * (w_68 * (platform_q0 * w_74 - w_28 * w_70)
                        + w_71 * (platform_q0 * w_75 + w_28 * w_66) - w_77) / w_73,
                S::from_f64(2.0) * sqrt_w_73
                    * (w_68 * (platform_q1 * w_74 + w_32 * w_70)
                        + w_71 * (w_32 * w_66 - w_33 * w_69 - w_35 * w_67) + w_78)
                    / w_73,
                S::from_f64(2.0) * sqrt_w_73
                    * (w_68 * (w_37 * w_70 - w_39 * w_69 - w_40 * w_67)
                        + w_71 * (platform_q2 * w_75 + w_37 * w_66) + w_79) / w_73,
                -(w_81 / w_73),
            ],
            [
                w_84 * sqrt_w_89 / w_89,
                w_87 * sqrt_w_89 / w_89,
                b2_on_platform_z * sqrt_w_89 / w_89,
                S::from_f64(2.0) * sqrt_w_89
                    * (w_84 * (platform_q0 * w_90 - w_28 * w_86)
                        + w_87 * (platform_q0 * w_91 + w_28 * w_82) - w_93) / w_89,
                S::from_f64(2.0) * sqrt_w_89
                    * (w_84 * (platform_q1 * w_90 + w_32 * w_86)
                        + w_87 * (w_32 * w_82 - w_33 * w_85 - w_35 * w_83) + w_94)
                    / w_89,
                S::from_f64(2.0) * sqrt_w_89
                    * (w_84 * (w_37 * w_86 - w_39 * w_85 - w_40 * w_83)
                        + w_87 * (platform_q2 * w_91 + w_37 * w_82) + w_95) / w_89,
                -(w_97 / w_89),
            ],
            [
                w_100 * sqrt_w_105 / w_105,
                w_103 * sqrt_w_105 / w_105,
                c1_on_platform_z * sqrt_w_105 / w_105,
                S::from_f64(2.0) * sqrt_w_105
                    * (w_100 * (platform_q0 * w_106 - w_28 * w_102)
                        + w_103 * (platform_q0 * w_107 + w_28 * w_98) - w_109) / w_105,
                S::from_f64(2.0) * sqrt_w_105
                    * (w_100 * (platform_q1 * w_106 + w_32 * w_102)
                        + w_103 * (w_32 * w_98 - w_33 * w_101 - w_35 * w_99) + w_110)
                    / w_105,
                S::from_f64(2.0) * sqrt_w_105
                    * (w_100 * (w_37 * w_102 - w_39 * w_101 - w_40 * w_99)
                        + w_103 * (platform_q2 * w_107 + w_37 * w_98) + w_111) / w_105,
                -(w_113 / w_105),
            ],
            [
                w_116 * sqrt_w_121 / w_121,
                w_119 * sqrt_w_121 / w_121,
                c2_on_platform_z * sqrt_w_121 / w_121,
                S::from_f64(2.0) * sqrt_w_121
                    * (w_116 * (platform_q0 * w_122 - w_28 * w_118)
                        + w_119 * (platform_q0 * w_123 + w_28 * w_114) - w_125) / w_121,
                S::from_f64(2.0) * sqrt_w_121
                    * (w_116 * (platform_q1 * w_122 + w_32 * w_118)
                        + w_119 * (w_32 * w_114 - w_33 * w_117 - w_35 * w_115) + w_126)
                    / w_121,
                S::from_f64(2.0) * sqrt_w_121
                    * (w_116 * (w_37 * w_118 - w_39 * w_117 - w_40 * w_115)
                        + w_119 * (platform_q2 * w_123 + w_37 * w_114) + w_127) / w_121,
                -(w_129 / w_121),
            ],
        ]
    }
    /// `C_t`, 7, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: 12 additions, 11 multiplications, 4 sine-cosine pairs.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 7]) -> [S; 7] {
        let w = self.w * t;
        let ([_, _, _, _], [cos_w, w_2, w_3, w_4]) = S::sin_cos_each([
            w,
            S::from_f64(0.6666666666666666) * S::from_f64(::core::f64::consts::PI) + w,
            S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333) + w,
            S::from_f64(::core::f64::consts::PI) * S::from_f64(2.0) + w,
        ]);
        let w_5 = self.heave * self.w;
        let w_6 = self.w * self.sway;
        let w_7 = w_6 * w_2;
        let w_8 = cos_w * w_5;
        let w_9 = w_6 * w_3;
        [
            S::from_f64(0.0),
            -(cos_w * (w_5 + w_6)),
            w_7 - w_8,
            -(w_8 + w_7),
            w_9 - w_8,
            -(w_8 + w_9),
            w_6 * w_4 - w_8,
        ]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 7, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 893 additions, 1442 multiplications, 25 divisions, 16 sine-cosine pairs, 6 square roots.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        let [platform_x, platform_y, platform_z, platform_q0, platform_q1, platform_q2,
        platform_q3] = *q;
        let [platform_x_dot, platform_y_dot, platform_z_dot, platform_q0_dot,
        platform_q1_dot, platform_q2_dot, platform_q3_dot] = *qd;
        let w = self.w * t;
        let w_2 = S::from_f64(0.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        let a1_head_angle = w_2 - self.head;
        let w_3 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_3 - self.foot;
        let a2_head_angle = w_2 + self.head;
        let b1_foot_angle = w_3 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_4 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333);
        let b2_foot_angle = w_4 - self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let c1_foot_angle = w_4 + self.foot;
        let w_5 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_5 - self.head;
        let w_6 = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI);
        let c2_foot_angle = w_6 - self.foot;
        let c2_head_angle = w_5 + self.head;
        let (
            [sin_w,
            sin_foot,
            sin_a1_head_angle,
            w_7,
            sin_a2_foot_angle,
            sin_a2_head_angle,
            sin_b1_foot_angle,
            sin_b1_head_angle,
            w_8,
            sin_b2_foot_angle,
            sin_b2_head_angle,
            sin_c1_foot_angle,
            sin_c1_head_angle,
            w_9,
            sin_c2_foot_angle,
            sin_c2_head_angle,
            ],
            [_,
            cos_foot,
            cos_a1_head_angle,
            _,
            cos_a2_foot_angle,
            cos_a2_head_angle,
            cos_b1_foot_angle,
            cos_b1_head_angle,
            _,
            cos_b2_foot_angle,
            cos_b2_head_angle,
            cos_c1_foot_angle,
            cos_c1_head_angle,
            _,
            cos_c2_foot_angle,
            cos_c2_head_angle,
            ],
        ) = S::sin_cos_each([
            w,
            self.foot,
            a1_head_angle,
            w_3 + w,
            a2_foot_angle,
            a2_head_angle,
            b1_foot_angle,
            b1_head_angle,
            w_4 + w,
            b2_foot_angle,
            b2_head_angle,
            c1_foot_angle,
            c1_head_angle,
            w_6 + w,
            c2_foot_angle,
            c2_head_angle,
        ]);
        let platform_q1_squared = platform_q1 * platform_q1;
        let platform_q2_squared = platform_q2 * platform_q2;
        let platform_q3_squared = platform_q3 * platform_q3;
        let w_10 = S::from_f64(1.0)
            / (platform_q0 * platform_q0 + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_11 = platform_q2_squared + platform_q3_squared;
        let w_12 = S::from_f64(2.0) * w_10 * w_11 - S::from_f64(1.0);
        let w_13 = self.r * cos_a1_head_angle;
        let w_14 = S::from_f64(2.0) * self.r;
        let w_15 = sin_a1_head_angle * w_14;
        let w_16 = platform_q1 * platform_q2;
        let w_17 = platform_q0 * platform_q3;
        let w_18 = w_16 - w_17;
        let w_19 = w_10 * w_18;
        let w_20 = platform_x - self.R * cos_foot - w_12 * w_13 + w_15 * w_19;
        let w_21 = cos_a1_head_angle * w_14;
        let w_22 = w_16 + w_17;
        let w_23 = w_10 * w_22;
        let w_24 = platform_q1_squared + platform_q3_squared;
        let w_25 = S::from_f64(2.0) * w_10 * w_24 - S::from_f64(1.0);
        let w_26 = self.r * sin_a1_head_angle;
        let w_27 = platform_y - self.R * sin_foot + w_21 * w_23 - w_25 * w_26;
        let w_28 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_29 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let w_30 = w_21 * w_28 + w_15 * w_29;
        let a1_on_platform_z = w_10 * w_30 + platform_z;
        let w_31 = w_20 * w_20 + w_27 * w_27 + a1_on_platform_z * a1_on_platform_z;
        let w_10_squared = w_10 * w_10;
        let w_32 = platform_q1_dot * platform_q1;
        let w_33 = platform_q2_dot * platform_q2;
        let w_34 = platform_q3_dot * platform_q3;
        let w_35 = platform_q0_dot * platform_q0 + w_32 + w_33 + w_34;
        let w_36 = w_11 * w_35;
        let w_37 = w_33 + w_34;
        let w_38 = w_10_squared * w_36 - w_10 * w_37;
        let w_39 = self.r * S::from_f64(4.0);
        let w_40 = cos_a1_head_angle * w_39;
        let w_41 = sin_a1_head_angle * w_39;
        let w_42 = w_18 * w_10_squared;
        let w_43 = w_35 * w_42;
        let w_44 = platform_q3_dot * platform_q0;
        let w_45 = platform_q0_dot * platform_q3;
        let w_46 = platform_q2_dot * platform_q1;
        let w_47 = platform_q1_dot * platform_q2;
        let w_48 = w_44 + w_45 - w_46 - w_47;
        let w_49 = w_10 * w_48;
        let w_50 = platform_x_dot + w_38 * w_40 - w_41 * w_43 - w_15 * w_49;
        let w_51 = w_44 + w_45 + w_46 + w_47;
        let w_52 = w_10 * w_51;
        let w_53 = w_22 * w_10_squared;
        let w_54 = w_35 * w_53;
        let w_55 = w_24 * w_35;
        let w_56 = w_32 + w_34;
        let w_57 = w_10_squared * w_55 - w_10 * w_56;
        let w_58 = platform_y_dot + w_21 * w_52 - w_40 * w_54 + w_41 * w_57;
        let w_59 = platform_q1_dot * platform_q0 + platform_q0_dot * platform_q1
            + platform_q3_dot * platform_q2 + platform_q2_dot * platform_q3;
        let w_60 = platform_q2_dot * platform_q0 + platform_q0_dot * platform_q2
            - platform_q1_dot * platform_q3 - platform_q3_dot * platform_q1;
        let w_61 = w_10 * (w_15 * w_59 - w_21 * w_60)
            - w_10_squared * w_35 * (w_28 * w_40 + w_29 * w_41) + platform_z_dot;
        let w_62 = w_20 * w_50 + w_27 * w_58 + a1_on_platform_z * w_61;
        let w_63 = platform_q0 * w_10;
        let w_64 = w_10 - w_11 * w_10_squared;
        let w_65 = platform_q3 * w_64;
        let w_66 = platform_q3 * w_42;
        let w_67 = w_26 * w_63 + w_21 * w_65 + w_15 * w_66;
        let w_68 = platform_q3 * w_53;
        let w_69 = w_10 - w_24 * w_10_squared;
        let w_70 = platform_q3 * w_69;
        let w_71 = w_13 * w_63 - w_21 * w_68 - w_15 * w_70;
        let w_72 = w_30 * w_10_squared;
        let w_73 = w_10 * (platform_q2 * w_26 + platform_q1 * w_13) - platform_q3 * w_72;
        let w_74 = w_10_squared * (w_11 * w_21 - w_18 * w_15);
        let w_75 = platform_q3 * w_10;
        let w_76 = platform_q0 * w_74 - w_26 * w_75;
        let w_77 = w_10_squared * (w_15 * w_24 - w_22 * w_21);
        let w_78 = platform_q0 * w_77 + w_13 * w_75;
        let w_79 = platform_q0 * w_72 + w_10 * (platform_q2 * w_13 - platform_q1 * w_26);
        let w_80 = platform_q2 * w_10;
        let w_81 = platform_q1 * w_74 + w_26 * w_80;
        let w_82 = platform_q1 * w_53;
        let w_83 = platform_q1 * w_69;
        let w_84 = w_13 * w_80 - w_21 * w_82 - w_15 * w_83;
        let w_85 = w_10 * (platform_q3 * w_13 + platform_q0 * w_26) - platform_q1 * w_72;
        let w_86 = platform_q1_dot
            * (w_20 * w_81 + w_27 * w_84 + a1_on_platform_z * w_85);
        let w_87 = platform_q1 * w_10;
        let w_88 = platform_q2 * w_64;
        let w_89 = platform_q2 * w_42;
        let w_90 = w_26 * w_87 - w_21 * w_88 - w_15 * w_89;
        let w_91 = platform_q2 * w_77 + w_13 * w_87;
        let w_92 = w_10 * (platform_q3 * w_26 - platform_q0 * w_13) - platform_q2 * w_72;
        let w_93 = platform_q2_dot
            * (w_20 * w_90 + w_27 * w_91 + a1_on_platform_z * w_92);
        let w_94 = platform_q3_dot
            * (w_20 * w_67 - w_27 * w_71 - a1_on_platform_z * w_73)
            - platform_q0_dot * (w_20 * w_76 + w_27 * w_78 - a1_on_platform_z * w_79)
            - w_86 - w_93;
        let w_31_squared = w_31 * w_31;
        let w_95 = platform_q3 * w_35;
        let w_96 = platform_q0 * w_48 - platform_q0_dot * w_18 + w_95;
        let w_97 = platform_q0_dot * w_11;
        let w_98 = platform_q0 * w_37;
        let w_99 = w_10 * w_10_squared;
        let w_100 = self.r * S::from_f64(8.0);
        let w_101 = sin_a1_head_angle * w_100;
        let w_102 = cos_a1_head_angle * w_100;
        let w_103 = w_35 * w_99 * (w_18 * w_101 - w_11 * w_102);
        let w_104 = platform_q3_dot * w_10;
        let w_105 = platform_q0_dot * w_24;
        let w_106 = w_95 + platform_q0_dot * w_22 + platform_q0 * w_51;
        let w_107 = platform_q0 * w_56;
        let w_108 = w_35 * w_99 * (w_22 * w_102 - w_24 * w_101);
        let w_109 = w_27
            * (w_10_squared * (w_15 * w_105 - w_21 * w_106 + w_41 * w_107)
                + platform_q0 * w_108 + w_13 * w_104);
        let w_110 = platform_q2 * w_35;
        let w_111 = platform_q0_dot * w_28 - platform_q0 * w_60 - w_110;
        let w_112 = platform_q1 * w_35;
        let w_113 = w_112 + platform_q0_dot * w_29 + platform_q0 * w_59;
        let w_114 = w_35 * w_99 * (w_28 * w_102 + w_29 * w_101);
        let w_115 = a1_on_platform_z
            * (w_10_squared * (w_21 * w_111 + w_15 * w_113) - platform_q0 * w_114
                + w_10 * (platform_q2_dot * w_13 - platform_q1_dot * w_26));
        let w_116 = w_50 * w_76
            + w_20
                * (w_10_squared * (w_15 * w_96 + w_21 * w_97 + w_40 * w_98)
                    + platform_q0 * w_103 - w_26 * w_104) + w_58 * w_78 + w_109
            - w_61 * w_79 - w_115;
        let w_117 = platform_q1 * w_48 - w_110 - platform_q1_dot * w_18;
        let w_118 = platform_q1_dot * w_11;
        let w_119 = platform_q1 * w_37;
        let w_120 = platform_q2_dot * w_10;
        let w_121 = w_20
            * (w_10_squared * (w_15 * w_117 + w_21 * w_118 + w_40 * w_119)
                + platform_q1 * w_103 + w_26 * w_120);
        let w_122 = w_10_squared * (w_110 + platform_q1_dot * w_22 + platform_q1 * w_51);
        let w_123 = w_35 * w_99;
        let w_124 = w_123 * platform_q1 * w_22;
        let w_125 = S::from_f64(4.0) * w_55 * w_99
            - S::from_f64(2.0) * w_10_squared * (w_35 + w_56);
        let w_126 = platform_q1 * w_125 + platform_q1_dot * w_69;
        let w_127 = platform_q1 * w_60 - w_95 - platform_q1_dot * w_28;
        let w_128 = platform_q0 * w_35;
        let w_129 = w_128 + platform_q1_dot * w_29 + platform_q1 * w_59;
        let w_130 = a1_on_platform_z
            * (w_10_squared * (w_21 * w_127 - w_15 * w_129)
                + w_10 * (platform_q3_dot * w_13 + platform_q0_dot * w_26)
                + platform_q1 * w_114);
        let w_131 = w_50 * w_81 + w_121 + w_58 * w_84
            + w_27 * (w_13 * w_120 - w_21 * w_122 + w_102 * w_124 - w_15 * w_126)
            + w_61 * w_85 + w_130;
        let w_132 = w_10_squared * (platform_q2 * w_48 - w_112 - platform_q2_dot * w_18);
        let w_133 = platform_q1_dot * w_10;
        let w_134 = S::from_f64(4.0) * w_36 * w_99
            - S::from_f64(2.0) * w_10_squared * (w_35 + w_37);
        let w_135 = platform_q2 * w_134 + platform_q2_dot * w_64;
        let w_136 = w_123 * platform_q2 * w_18;
        let w_137 = platform_q2_dot * w_24;
        let w_138 = w_112 + platform_q2_dot * w_22 + platform_q2 * w_51;
        let w_139 = platform_q2 * w_56;
        let w_140 = w_27
            * (w_10_squared * (w_15 * w_137 - w_21 * w_138 + w_41 * w_139)
                + platform_q2 * w_108 + w_13 * w_133);
        let w_141 = platform_q2 * w_60 - platform_q2_dot * w_28 + w_128;
        let w_142 = w_95 + platform_q2_dot * w_29 + platform_q2 * w_59;
        let w_143 = a1_on_platform_z
            * (w_10_squared * (w_21 * w_141 - w_15 * w_142)
                + w_10 * (platform_q3_dot * w_26 - platform_q0_dot * w_13)
                + platform_q2 * w_114);
        let w_144 = w_50 * w_90
            + w_20 * (w_15 * w_132 + w_26 * w_133 - w_21 * w_135 + w_101 * w_136)
            + w_58 * w_91 + w_140 + w_61 * w_92 + w_143;
        let w_145 = w_10_squared * (platform_q3_dot * w_18 - w_128 - platform_q3 * w_48);
        let w_146 = platform_q0_dot * w_10;
        let w_147 = platform_q3 * w_134 + platform_q3_dot * w_64;
        let w_148 = platform_q3 * w_123;
        let w_149 = w_18 * w_148;
        let w_150 = w_10_squared * (w_128 + platform_q3_dot * w_22 + platform_q3 * w_51);
        let w_151 = w_22 * w_148;
        let w_152 = platform_q3 * w_125 + platform_q3_dot * w_69;
        let w_153 = w_27 * (w_13 * w_146 - w_21 * w_150 + w_102 * w_151 - w_15 * w_152);
        let w_154 = platform_q3 * w_60 - w_112 - platform_q3_dot * w_28;
        let w_155 = w_110 + platform_q3_dot * w_29 + platform_q3 * w_59;
        let w_156 = a1_on_platform_z
            * (w_10_squared * (w_21 * w_154 - w_15 * w_155)
                + w_10 * (platform_q2_dot * w_26 + platform_q1_dot * w_13)
                + platform_q3 * w_114);
        let w_157 = w_50 * w_67
            + w_20 * (w_15 * w_145 + w_26 * w_146 + w_21 * w_147 - w_101 * w_149)
            - w_58 * w_71 - w_153 - w_61 * w_73 - w_156;
        let w_158 = S::from_f64(2.0)
            * (w_62 * (w_94 / w_31_squared)
                + (platform_q0_dot * w_116 + platform_q1_dot * w_131
                    + platform_q2_dot * w_144 - platform_q3_dot * w_157) / w_31);
        let w_159 = w_158
            + (platform_x_dot * w_50 + platform_y_dot * w_58 + platform_z_dot * w_61)
                / w_31
            - w_62
                * ((platform_x_dot * w_20 + w_27 * platform_y_dot
                    + a1_on_platform_z * platform_z_dot) / w_31_squared);
        let w_squared = self.w * self.w;
        let w_160 = self.heave * w_squared;
        let w_161 = w_squared * self.sway;
        let w_162 = self.r * cos_a2_head_angle;
        let w_163 = w_14 * sin_a2_head_angle;
        let w_164 = platform_x - self.R * cos_a2_foot_angle - w_12 * w_162
            + w_19 * w_163;
        let w_165 = w_14 * cos_a2_head_angle;
        let w_166 = self.r * sin_a2_head_angle;
        let w_167 = platform_y - self.R * sin_a2_foot_angle + w_23 * w_165
            - w_25 * w_166;
        let w_168 = w_28 * w_165 + w_29 * w_163;
        let a2_on_platform_z = w_10 * w_168 + platform_z;
        let w_169 = w_164 * w_164 + w_167 * w_167 + a2_on_platform_z * a2_on_platform_z;
        let w_170 = w_39 * cos_a2_head_angle;
        let w_171 = w_39 * sin_a2_head_angle;
        let w_172 = platform_x_dot + w_38 * w_170 - w_43 * w_171 - w_49 * w_163;
        let w_173 = platform_y_dot + w_52 * w_165 - w_54 * w_170 + w_57 * w_171;
        let w_174 = w_10 * (w_59 * w_163 - w_60 * w_165)
            - w_10_squared * w_35 * (w_28 * w_170 + w_29 * w_171) + platform_z_dot;
        let w_175 = w_164 * w_172 + w_167 * w_173 + a2_on_platform_z * w_174;
        let w_176 = w_63 * w_166 + w_65 * w_165 + w_66 * w_163;
        let w_177 = w_63 * w_162 - w_68 * w_165 - w_70 * w_163;
        let w_178 = w_10_squared * w_168;
        let w_179 = w_10 * (platform_q2 * w_166 + platform_q1 * w_162)
            - platform_q3 * w_178;
        let w_180 = w_10_squared * (w_11 * w_165 - w_18 * w_163);
        let w_181 = platform_q0 * w_180 - w_75 * w_166;
        let w_182 = w_10_squared * (w_24 * w_163 - w_22 * w_165);
        let w_183 = platform_q0 * w_182 + w_75 * w_162;
        let w_184 = platform_q0 * w_178
            + w_10 * (platform_q2 * w_162 - platform_q1 * w_166);
        let w_185 = platform_q1 * w_180 + w_80 * w_166;
        let w_186 = w_80 * w_162 - w_82 * w_165 - w_83 * w_163;
        let w_187 = w_10 * (platform_q3 * w_162 + platform_q0 * w_166)
            - platform_q1 * w_178;
        let w_188 = platform_q1_dot
            * (w_164 * w_185 + w_167 * w_186 + a2_on_platform_z * w_187);
        let w_189 = w_87 * w_166 - w_88 * w_165 - w_89 * w_163;
        let w_190 = platform_q2 * w_182 + w_87 * w_162;
        let w_191 = w_10 * (platform_q3 * w_166 - platform_q0 * w_162)
            - platform_q2 * w_178;
        let w_192 = platform_q2_dot
            * (w_164 * w_189 + w_167 * w_190 + a2_on_platform_z * w_191);
        let w_193 = platform_q3_dot
            * (w_164 * w_176 - w_167 * w_177 - a2_on_platform_z * w_179)
            - platform_q0_dot
                * (w_164 * w_181 + w_167 * w_183 - a2_on_platform_z * w_184) - w_188
            - w_192;
        let w_169_squared = w_169 * w_169;
        let w_194 = w_100 * sin_a2_head_angle;
        let w_195 = w_100 * cos_a2_head_angle;
        let w_196 = w_35 * w_99 * (w_18 * w_194 - w_11 * w_195);
        let w_197 = w_35 * w_99 * (w_22 * w_195 - w_24 * w_194);
        let w_198 = w_167
            * (w_10_squared * (w_105 * w_163 - w_106 * w_165 + w_107 * w_171)
                + platform_q0 * w_197 + w_104 * w_162);
        let w_199 = w_35 * w_99 * (w_28 * w_195 + w_29 * w_194);
        let w_200 = a2_on_platform_z
            * (w_10_squared * (w_111 * w_165 + w_113 * w_163) - platform_q0 * w_199
                + w_10 * (platform_q2_dot * w_162 - platform_q1_dot * w_166));
        let w_201 = w_172 * w_181
            + w_164
                * (w_10_squared * (w_96 * w_163 + w_97 * w_165 + w_98 * w_170)
                    + platform_q0 * w_196 - w_104 * w_166) + w_173 * w_183 + w_198
            - w_174 * w_184 - w_200;
        let w_202 = w_164
            * (w_10_squared * (w_117 * w_163 + w_118 * w_165 + w_119 * w_170)
                + platform_q1 * w_196 + w_120 * w_166);
        let w_203 = a2_on_platform_z
            * (w_10_squared * (w_127 * w_165 - w_129 * w_163)
                + w_10 * (platform_q3_dot * w_162 + platform_q0_dot * w_166)
                + platform_q1 * w_199);
        let w_204 = w_172 * w_185 + w_202 + w_173 * w_186
            + w_167 * (w_120 * w_162 - w_122 * w_165 + w_124 * w_195 - w_126 * w_163)
            + w_174 * w_187 + w_203;
        let w_205 = w_167
            * (w_10_squared * (w_137 * w_163 - w_138 * w_165 + w_139 * w_171)
                + platform_q2 * w_197 + w_133 * w_162);
        let w_206 = a2_on_platform_z
            * (w_10_squared * (w_141 * w_165 - w_142 * w_163)
                + w_10 * (platform_q3_dot * w_166 - platform_q0_dot * w_162)
                + platform_q2 * w_199);
        let w_207 = w_172 * w_189
            + w_164 * (w_132 * w_163 + w_133 * w_166 - w_135 * w_165 + w_136 * w_194)
            + w_173 * w_190 + w_205 + w_174 * w_191 + w_206;
        let w_208 = w_167
            * (w_146 * w_162 - w_150 * w_165 + w_151 * w_195 - w_152 * w_163);
        let w_209 = a2_on_platform_z
            * (w_10_squared * (w_154 * w_165 - w_155 * w_163)
                + w_10 * (platform_q2_dot * w_166 + platform_q1_dot * w_162)
                + platform_q3 * w_199);
        let w_210 = w_172 * w_176
            + w_164 * (w_145 * w_163 + w_146 * w_166 + w_147 * w_165 - w_149 * w_194)
            - w_173 * w_177 - w_208 - w_174 * w_179 - w_209;
        let w_211 = S::from_f64(2.0)
            * (w_175 * (w_193 / w_169_squared)
                + (platform_q0_dot * w_201 + platform_q1_dot * w_204
                    + platform_q2_dot * w_207 - platform_q3_dot * w_210) / w_169);
        let w_212 = w_211
            + (platform_x_dot * w_172 + platform_y_dot * w_173 + platform_z_dot * w_174)
                / w_169
            - w_175
                * ((platform_x_dot * w_164 + platform_y_dot * w_167
                    + platform_z_dot * a2_on_platform_z) / w_169_squared);
        let w_213 = sin_w * w_160;
        let w_214 = w_161 * w_7;
        let w_215 = self.r * cos_b1_head_angle;
        let w_216 = w_14 * sin_b1_head_angle;
        let w_217 = platform_x - self.R * cos_b1_foot_angle - w_12 * w_215
            + w_19 * w_216;
        let w_218 = w_14 * cos_b1_head_angle;
        let w_219 = self.r * sin_b1_head_angle;
        let w_220 = platform_y - self.R * sin_b1_foot_angle + w_23 * w_218
            - w_25 * w_219;
        let w_221 = w_28 * w_218 + w_29 * w_216;
        let b1_on_platform_z = w_10 * w_221 + platform_z;
        let w_222 = w_217 * w_217 + w_220 * w_220 + b1_on_platform_z * b1_on_platform_z;
        let w_223 = w_39 * cos_b1_head_angle;
        let w_224 = w_39 * sin_b1_head_angle;
        let w_225 = platform_x_dot + w_38 * w_223 - w_43 * w_224 - w_49 * w_216;
        let w_226 = platform_y_dot + w_52 * w_218 - w_54 * w_223 + w_57 * w_224;
        let w_227 = w_10 * (w_59 * w_216 - w_60 * w_218)
            - w_10_squared * w_35 * (w_28 * w_223 + w_29 * w_224) + platform_z_dot;
        let w_228 = w_217 * w_225 + w_220 * w_226 + b1_on_platform_z * w_227;
        let w_229 = w_63 * w_219 + w_65 * w_218 + w_66 * w_216;
        let w_230 = w_63 * w_215 - w_68 * w_218 - w_70 * w_216;
        let w_231 = w_10_squared * w_221;
        let w_232 = w_10 * (platform_q2 * w_219 + platform_q1 * w_215)
            - platform_q3 * w_231;
        let w_233 = w_10_squared * (w_11 * w_218 - w_18 * w_216);
        let w_234 = platform_q0 * w_233 - w_75 * w_219;
        let w_235 = w_10_squared * (w_24 * w_216 - w_22 * w_218);
        let w_236 = platform_q0 * w_235 + w_75 * w_215;
        let w_237 = platform_q0 * w_231
            + w_10 * (platform_q2 * w_215 - platform_q1 * w_219);
        let w_238 = platform_q1 * w_233 + w_80 * w_219;
        let w_239 = w_80 * w_215 - w_82 * w_218 - w_83 * w_216;
        let w_240 = w_10 * (platform_q3 * w_215 + platform_q0 * w_219)
            - platform_q1 * w_231;
        let w_241 = platform_q1_dot
            * (w_217 * w_238 + w_220 * w_239 + b1_on_platform_z * w_240);
        let w_242 = w_87 * w_219 - w_88 * w_218 - w_89 * w_216;
        let w_243 = platform_q2 * w_235 + w_87 * w_215;
        let w_244 = w_10 * (platform_q3 * w_219 - platform_q0 * w_215)
            - platform_q2 * w_231;
        let w_245 = platform_q2_dot
            * (w_217 * w_242 + w_220 * w_243 + b1_on_platform_z * w_244);
        let w_246 = platform_q3_dot
            * (w_217 * w_229 - w_220 * w_230 - b1_on_platform_z * w_232)
            - platform_q0_dot
                * (w_217 * w_234 + w_220 * w_236 - b1_on_platform_z * w_237) - w_241
            - w_245;
        let w_222_squared = w_222 * w_222;
        let w_247 = w_100 * sin_b1_head_angle;
        let w_248 = w_100 * cos_b1_head_angle;
        let w_249 = w_35 * w_99 * (w_18 * w_247 - w_11 * w_248);
        let w_250 = w_35 * w_99 * (w_22 * w_248 - w_24 * w_247);
        let w_251 = w_220
            * (w_10_squared * (w_105 * w_216 - w_106 * w_218 + w_107 * w_224)
                + platform_q0 * w_250 + w_104 * w_215);
        let w_252 = w_35 * w_99 * (w_28 * w_248 + w_29 * w_247);
        let w_253 = b1_on_platform_z
            * (w_10_squared * (w_111 * w_218 + w_113 * w_216) - platform_q0 * w_252
                + w_10 * (platform_q2_dot * w_215 - platform_q1_dot * w_219));
        let w_254 = w_225 * w_234
            + w_217
                * (w_10_squared * (w_96 * w_216 + w_97 * w_218 + w_98 * w_223)
                    + platform_q0 * w_249 - w_104 * w_219) + w_226 * w_236 + w_251
            - w_227 * w_237 - w_253;
        let w_255 = w_217
            * (w_10_squared * (w_117 * w_216 + w_118 * w_218 + w_119 * w_223)
                + platform_q1 * w_249 + w_120 * w_219);
        let w_256 = b1_on_platform_z
            * (w_10_squared * (w_127 * w_218 - w_129 * w_216)
                + w_10 * (platform_q3_dot * w_215 + platform_q0_dot * w_219)
                + platform_q1 * w_252);
        let w_257 = w_225 * w_238 + w_255 + w_226 * w_239
            + w_220 * (w_120 * w_215 - w_122 * w_218 + w_124 * w_248 - w_126 * w_216)
            + w_227 * w_240 + w_256;
        let w_258 = w_220
            * (w_10_squared * (w_137 * w_216 - w_138 * w_218 + w_139 * w_224)
                + platform_q2 * w_250 + w_133 * w_215);
        let w_259 = b1_on_platform_z
            * (w_10_squared * (w_141 * w_218 - w_142 * w_216)
                + w_10 * (platform_q3_dot * w_219 - platform_q0_dot * w_215)
                + platform_q2 * w_252);
        let w_260 = w_225 * w_242
            + w_217 * (w_132 * w_216 + w_133 * w_219 - w_135 * w_218 + w_136 * w_247)
            + w_226 * w_243 + w_258 + w_227 * w_244 + w_259;
        let w_261 = w_220
            * (w_146 * w_215 - w_150 * w_218 + w_151 * w_248 - w_152 * w_216);
        let w_262 = b1_on_platform_z
            * (w_10_squared * (w_154 * w_218 - w_155 * w_216)
                + w_10 * (platform_q2_dot * w_219 + platform_q1_dot * w_215)
                + platform_q3 * w_252);
        let w_263 = w_225 * w_229
            + w_217 * (w_145 * w_216 + w_146 * w_219 + w_147 * w_218 - w_149 * w_247)
            - w_226 * w_230 - w_261 - w_227 * w_232 - w_262;
        let w_264 = S::from_f64(2.0)
            * (w_228 * (w_246 / w_222_squared)
                + (platform_q0_dot * w_254 + platform_q1_dot * w_257
                    + platform_q2_dot * w_260 - platform_q3_dot * w_263) / w_222);
        let w_265 = w_264
            + (platform_x_dot * w_225 + platform_y_dot * w_226 + platform_z_dot * w_227)
                / w_222
            - w_228
                * ((platform_x_dot * w_217 + platform_y_dot * w_220
                    + platform_z_dot * b1_on_platform_z) / w_222_squared);
        let w_266 = self.r * cos_b2_head_angle;
        let w_267 = w_14 * sin_b2_head_angle;
        let w_268 = platform_x - self.R * cos_b2_foot_angle - w_12 * w_266
            + w_19 * w_267;
        let w_269 = w_14 * cos_b2_head_angle;
        let w_270 = self.r * sin_b2_head_angle;
        let w_271 = platform_y - self.R * sin_b2_foot_angle + w_23 * w_269
            - w_25 * w_270;
        let w_272 = w_28 * w_269 + w_29 * w_267;
        let b2_on_platform_z = w_10 * w_272 + platform_z;
        let w_273 = w_268 * w_268 + w_271 * w_271 + b2_on_platform_z * b2_on_platform_z;
        let w_274 = w_39 * cos_b2_head_angle;
        let w_275 = w_39 * sin_b2_head_angle;
        let w_276 = platform_x_dot + w_38 * w_274 - w_43 * w_275 - w_49 * w_267;
        let w_277 = platform_y_dot + w_52 * w_269 - w_54 * w_274 + w_57 * w_275;
        let w_278 = w_10 * (w_59 * w_267 - w_60 * w_269)
            - w_10_squared * w_35 * (w_28 * w_274 + w_29 * w_275) + platform_z_dot;
        let w_279 = w_268 * w_276 + w_271 * w_277 + b2_on_platform_z * w_278;
        let w_280 = w_63 * w_270 + w_65 * w_269 + w_66 * w_267;
        let w_281 = w_63 * w_266 - w_68 * w_269 - w_70 * w_267;
        let w_282 = w_10_squared * w_272;
        let w_283 = w_10 * (platform_q2 * w_270 + platform_q1 * w_266)
            - platform_q3 * w_282;
        let w_284 = w_10_squared * (w_11 * w_269 - w_18 * w_267);
        let w_285 = platform_q0 * w_284 - w_75 * w_270;
        let w_286 = w_10_squared * (w_24 * w_267 - w_22 * w_269);
        let w_287 = platform_q0 * w_286 + w_75 * w_266;
        let w_288 = platform_q0 * w_282
            + w_10 * (platform_q2 * w_266 - platform_q1 * w_270);
        let w_289 = platform_q1 * w_284 + w_80 * w_270;
        let w_290 = w_80 * w_266 - w_82 * w_269 - w_83 * w_267;
        let w_291 = w_10 * (platform_q3 * w_266 + platform_q0 * w_270)
            - platform_q1 * w_282;
        let w_292 = platform_q1_dot
            * (w_268 * w_289 + w_271 * w_290 + b2_on_platform_z * w_291);
        let w_293 = w_87 * w_270 - w_88 * w_269 - w_89 * w_267;
        let w_294 = platform_q2 * w_286 + w_87 * w_266;
        let w_295 = w_10 * (platform_q3 * w_270 - platform_q0 * w_266)
            - platform_q2 * w_282;
        let w_296 = platform_q2_dot
            * (w_268 * w_293 + w_271 * w_294 + b2_on_platform_z * w_295);
        let w_297 = platform_q3_dot
            * (w_268 * w_280 - w_271 * w_281 - b2_on_platform_z * w_283)
            - platform_q0_dot
                * (w_268 * w_285 + w_271 * w_287 - b2_on_platform_z * w_288) - w_292
            - w_296;
        let w_273_squared = w_273 * w_273;
        let w_298 = w_100 * sin_b2_head_angle;
        let w_299 = w_100 * cos_b2_head_angle;
        let w_300 = w_35 * w_99 * (w_18 * w_298 - w_11 * w_299);
        let w_301 = w_35 * w_99 * (w_22 * w_299 - w_24 * w_298);
        let w_302 = w_271
            * (w_10_squared * (w_105 * w_267 - w_106 * w_269 + w_107 * w_275)
                + platform_q0 * w_301 + w_104 * w_266);
        let w_303 = w_35 * w_99 * (w_28 * w_299 + w_29 * w_298);
        let w_304 = b2_on_platform_z
            * (w_10_squared * (w_111 * w_269 + w_113 * w_267) - platform_q0 * w_303
                + w_10 * (platform_q2_dot * w_266 - platform_q1_dot * w_270));
        let w_305 = w_276 * w_285
            + w_268
                * (w_10_squared * (w_96 * w_267 + w_97 * w_269 + w_98 * w_274)
                    + platform_q0 * w_300 - w_104 * w_270) + w_277 * w_287 + w_302
            - w_278 * w_288 - w_304;
        let w_306 = w_268
            * (w_10_squared * (w_117 * w_267 + w_118 * w_269 + w_119 * w_274)
                + platform_q1 * w_300 + w_120 * w_270);
        let w_307 = b2_on_platform_z
            * (w_10_squared * (w_127 * w_269 - w_129 * w_267)
                + w_10 * (platform_q3_dot * w_266 + platform_q0_dot * w_270)
                + platform_q1 * w_303);
        let w_308 = w_276 * w_289 + w_306 + w_277 * w_290
            + w_271 * (w_120 * w_266 - w_122 * w_269 + w_124 * w_299 - w_126 * w_267)
            + w_278 * w_291 + w_307;
        let w_309 = w_271
            * (w_10_squared * (w_137 * w_267 - w_138 * w_269 + w_139 * w_275)
                + platform_q2 * w_301 + w_133 * w_266);
        let w_310 = b2_on_platform_z
            * (w_10_squared * (w_141 * w_269 - w_142 * w_267)
                + w_10 * (platform_q3_dot * w_270 - platform_q0_dot * w_266)
                + platform_q2 * w_303);
        let w_311 = w_276 * w_293
            + w_268 * (w_132 * w_267 + w_133 * w_270 - w_135 * w_269 + w_136 * w_298)
            + w_277 * w_294 + w_309 + w_278 * w_295 + w_310;
        let w_312 = w_271
            * (w_146 * w_266 - w_150 * w_269 + w_151 * w_299 - w_152 * w_267);
        let w_313 = b2_on_platform_z
            * (w_10_squared * (w_154 * w_269 - w_155 * w_267)
                + w_10 * (platform_q2_dot * w_270 + platform_q1_dot * w_266)
                + platform_q3 * w_303);
        let w_314 = w_276 * w_280
            + w_268 * (w_145 * w_267 + w_146 * w_270 + w_147 * w_269 - w_149 * w_298)
            - w_277 * w_281 - w_312 - w_278 * w_283 - w_313;
        let w_315 = S::from_f64(2.0)
            * (w_279 * (w_297 / w_273_squared)
                + (platform_q0_dot * w_305 + platform_q1_dot * w_308
                    + platform_q2_dot * w_311 - platform_q3_dot * w_314) / w_273);
        let w_316 = w_315
            + (platform_x_dot * w_276 + platform_y_dot * w_277 + platform_z_dot * w_278)
                / w_273
            - w_279
                * ((platform_x_dot * w_268 + platform_y_dot * w_271
                    + platform_z_dot * b2_on_platform_z) / w_273_squared);
        let w_317 = w_161 * w_8;
        let w_318 = self.r * cos_c1_head_angle;
        let w_319 = w_14 * sin_c1_head_angle;
        let w_320 = platform_x - self.R * cos_c1_foot_angle - w_12 * w_318
            + w_19 * w_319;
        let w_321 = w_14 * cos_c1_head_angle;
        let w_322 = self.r * sin_c1_head_angle;
        let w_323 = platform_y - self.R * sin_c1_foot_angle + w_23 * w_321
            - w_25 * w_322;
        let w_324 = w_28 * w_321 + w_29 * w_319;
        let c1_on_platform_z = w_10 * w_324 + platform_z;
        let w_325 = w_320 * w_320 + w_323 * w_323 + c1_on_platform_z * c1_on_platform_z;
        let w_326 = w_39 * cos_c1_head_angle;
        let w_327 = w_39 * sin_c1_head_angle;
        let w_328 = platform_x_dot + w_38 * w_326 - w_43 * w_327 - w_49 * w_319;
        let w_329 = platform_y_dot + w_52 * w_321 - w_54 * w_326 + w_57 * w_327;
        let w_330 = w_10 * (w_59 * w_319 - w_60 * w_321)
            - w_10_squared * w_35 * (w_28 * w_326 + w_29 * w_327) + platform_z_dot;
        let w_331 = w_320 * w_328 + w_323 * w_329 + c1_on_platform_z * w_330;
        let w_332 = w_63 * w_322 + w_65 * w_321 + w_66 * w_319;
        let w_333 = w_63 * w_318 - w_68 * w_321 - w_70 * w_319;
        let w_334 = w_10_squared * w_324;
        let w_335 = w_10 * (platform_q2 * w_322 + platform_q1 * w_318)
            - platform_q3 * w_334;
        let w_336 = w_10_squared * (w_11 * w_321 - w_18 * w_319);
        let w_337 = platform_q0 * w_336 - w_75 * w_322;
        let w_338 = w_10_squared * (w_24 * w_319 - w_22 * w_321);
        let w_339 = platform_q0 * w_338 + w_75 * w_318;
        let w_340 = platform_q0 * w_334
            + w_10 * (platform_q2 * w_318 - platform_q1 * w_322);
        let w_341 = platform_q1 * w_336 + w_80 * w_322;
        let w_342 = w_80 * w_318 - w_82 * w_321 - w_83 * w_319;
        let w_343 = w_10 * (platform_q3 * w_318 + platform_q0 * w_322)
            - platform_q1 * w_334;
        let w_344 = platform_q1_dot
            * (w_320 * w_341 + w_323 * w_342 + c1_on_platform_z * w_343);
        let w_345 = w_87 * w_322 - w_88 * w_321 - w_89 * w_319;
        let w_346 = platform_q2 * w_338 + w_87 * w_318;
        let w_347 = w_10 * (platform_q3 * w_322 - platform_q0 * w_318)
            - platform_q2 * w_334;
        let w_348 = platform_q2_dot
            * (w_320 * w_345 + w_323 * w_346 + c1_on_platform_z * w_347);
        let w_349 = platform_q3_dot
            * (w_320 * w_332 - w_323 * w_333 - c1_on_platform_z * w_335)
            - platform_q0_dot
                * (w_320 * w_337 + w_323 * w_339 - c1_on_platform_z * w_340) - w_344
            - w_348;
        let w_325_squared = w_325 * w_325;
        let w_350 = w_100 * sin_c1_head_angle;
        let w_351 = w_100 * cos_c1_head_angle;
        let w_352 = w_35 * w_99 * (w_18 * w_350 - w_11 * w_351);
        let w_353 = w_35 * w_99 * (w_22 * w_351 - w_24 * w_350);
        let w_354 = w_323
            * (w_10_squared * (w_105 * w_319 - w_106 * w_321 + w_107 * w_327)
                + platform_q0 * w_353 + w_104 * w_318);
        let w_355 = w_35 * w_99 * (w_28 * w_351 + w_29 * w_350);
        let w_356 = c1_on_platform_z
            * (w_10_squared * (w_111 * w_321 + w_113 * w_319) - platform_q0 * w_355
                + w_10 * (platform_q2_dot * w_318 - platform_q1_dot * w_322));
        let w_357 = w_328 * w_337
            + w_320
                * (w_10_squared * (w_96 * w_319 + w_97 * w_321 + w_98 * w_326)
                    + platform_q0 * w_352 - w_104 * w_322) + w_329 * w_339 + w_354
            - w_330 * w_340 - w_356;
        let w_358 = w_320
            * (w_10_squared * (w_117 * w_319 + w_118 * w_321 + w_119 * w_326)
                + platform_q1 * w_352 + w_120 * w_322);
        let w_359 = c1_on_platform_z
            * (w_10_squared * (w_127 * w_321 - w_129 * w_319)
                + w_10 * (platform_q3_dot * w_318 + platform_q0_dot * w_322)
                + platform_q1 * w_355);
        let w_360 = w_328 * w_341 + w_358 + w_329 * w_342
            + w_323 * (w_120 * w_318 - w_122 * w_321 + w_124 * w_351 - w_126 * w_319)
            + w_330 * w_343 + w_359;
        let w_361 = w_323
            * (w_10_squared * (w_137 * w_319 - w_138 * w_321 + w_139 * w_327)
                + platform_q2 * w_353 + w_133 * w_318);
        let w_362 = c1_on_platform_z
            * (w_10_squared * (w_141 * w_321 - w_142 * w_319)
                + w_10 * (platform_q3_dot * w_322 - platform_q0_dot * w_318)
                + platform_q2 * w_355);
        let w_363 = w_328 * w_345
            + w_320 * (w_132 * w_319 + w_133 * w_322 - w_135 * w_321 + w_136 * w_350)
            + w_329 * w_346 + w_361 + w_330 * w_347 + w_362;
        let w_364 = w_323
            * (w_146 * w_318 - w_150 * w_321 + w_151 * w_351 - w_152 * w_319);
        let w_365 = c1_on_platform_z
            * (w_10_squared * (w_154 * w_321 - w_155 * w_319)
                + w_10 * (platform_q2_dot * w_322 + platform_q1_dot * w_318)
                + platform_q3 * w_355);
        let w_366 = w_328 * w_332
            + w_320 * (w_145 * w_319 + w_146 * w_322 + w_147 * w_321 - w_149 * w_350)
            - w_329 * w_333 - w_364 - w_330 * w_335 - w_365;
        let w_367 = S::from_f64(2.0)
            * (w_331 * (w_349 / w_325_squared)
                + (platform_q0_dot * w_357 + platform_q1_dot * w_360
                    + platform_q2_dot * w_363 - platform_q3_dot * w_366) / w_325);
        let w_368 = w_367
            + (platform_x_dot * w_328 + platform_y_dot * w_329 + platform_z_dot * w_330)
                / w_325
            - w_331
                * ((platform_x_dot * w_320 + platform_y_dot * w_323
                    + platform_z_dot * c1_on_platform_z) / w_325_squared);
        let w_369 = self.r * cos_c2_head_angle;
        let w_370 = w_14 * sin_c2_head_angle;
        let w_371 = platform_x - self.R * cos_c2_foot_angle - w_12 * w_369
            + w_19 * w_370;
        let w_372 = w_14 * cos_c2_head_angle;
        let w_373 = self.r * sin_c2_head_angle;
        let w_374 = platform_y - self.R * sin_c2_foot_angle + w_23 * w_372
            - w_25 * w_373;
        let w_375 = w_28 * w_372 + w_29 * w_370;
        let c2_on_platform_z = w_10 * w_375 + platform_z;
        let w_376 = w_371 * w_371 + w_374 * w_374 + c2_on_platform_z * c2_on_platform_z;
        let w_377 = w_39 * cos_c2_head_angle;
        let w_378 = w_39 * sin_c2_head_angle;
        let w_379 = platform_x_dot + w_38 * w_377 - w_43 * w_378 - w_49 * w_370;
        let w_380 = platform_y_dot + w_52 * w_372 - w_54 * w_377 + w_57 * w_378;
        let w_381 = w_10 * (w_59 * w_370 - w_60 * w_372)
            - w_10_squared * w_35 * (w_28 * w_377 + w_29 * w_378) + platform_z_dot;
        let w_382 = w_371 * w_379 + w_374 * w_380 + c2_on_platform_z * w_381;
        let w_383 = w_63 * w_373 + w_65 * w_372 + w_66 * w_370;
        let w_384 = w_63 * w_369 - w_68 * w_372 - w_70 * w_370;
        let w_385 = w_10_squared * w_375;
        let w_386 = w_10 * (platform_q2 * w_373 + platform_q1 * w_369)
            - platform_q3 * w_385;
        let w_387 = w_10_squared * (w_11 * w_372 - w_18 * w_370);
        let w_388 = platform_q0 * w_387 - w_75 * w_373;
        let w_389 = w_10_squared * (w_24 * w_370 - w_22 * w_372);
        let w_390 = platform_q0 * w_389 + w_75 * w_369;
        let w_391 = platform_q0 * w_385
            + w_10 * (platform_q2 * w_369 - platform_q1 * w_373);
        let w_392 = platform_q1 * w_387 + w_80 * w_373;
        let w_393 = w_80 * w_369 - w_82 * w_372 - w_83 * w_370;
        let w_394 = w_10 * (platform_q3 * w_369 + platform_q0 * w_373)
            - platform_q1 * w_385;
        let w_395 = platform_q1_dot
            * (w_371 * w_392 + w_374 * w_393 + c2_on_platform_z * w_394);
        let w_396 = w_87 * w_373 - w_88 * w_372 - w_89 * w_370;
        let w_397 = platform_q2 * w_389 + w_87 * w_369;
        let w_398 = w_10 * (platform_q3 * w_373 - platform_q0 * w_369)
            - platform_q2 * w_385;
        let w_399 = platform_q2_dot
            * (w_371 * w_396 + w_374 * w_397 + c2_on_platform_z * w_398);
        let w_400 = platform_q3_dot
            * (w_371 * w_383 - w_374 * w_384 - c2_on_platform_z * w_386)
            - platform_q0_dot
                * (w_371 * w_388 + w_374 * w_390 - c2_on_platform_z * w_391) - w_395
            - w_399;
        let w_376_squared = w_376 * w_376;
        let w_401 = w_100 * sin_c2_head_angle;
        let w_402 = w_100 * cos_c2_head_angle;
        let w_403 = w_35 * w_99 * (w_18 * w_401 - w_11 * w_402);
        let w_404 = w_35 * w_99 * (w_22 * w_402 - w_24 * w_401);
        let w_405 = w_374
            * (w_10_squared * (w_105 * w_370 - w_106 * w_372 + w_107 * w_378)
                + platform_q0 * w_404 + w_104 * w_369);
        let w_406 = w_35 * w_99 * (w_28 * w_402 + w_29 * w_401);
        let w_407 = c2_on_platform_z
            * (w_10_squared * (w_111 * w_372 + w_113 * w_370) - platform_q0 * w_406
                + w_10 * (platform_q2_dot * w_369 - platform_q1_dot * w_373));
        let w_408 = w_379 * w_388
            + w_371
                * (w_10_squared * (w_96 * w_370 + w_97 * w_372 + w_98 * w_377)
                    + platform_q0 * w_403 - w_104 * w_373) + w_380 * w_390 + w_405
            - w_381 * w_391 - w_407;
        let w_409 = w_371
            * (w_10_squared * (w_117 * w_370 + w_118 * w_372 + w_119 * w_377)
                + platform_q1 * w_403 + w_120 * w_373);
        let w_410 = c2_on_platform_z
            * (w_10_squared * (w_127 * w_372 - w_129 * w_370)
                + w_10 * (platform_q3_dot * w_369 + platform_q0_dot * w_373)
                + platform_q1 * w_406);
        let w_411 = w_379 * w_392 + w_409 + w_380 * w_393
            + w_374 * (w_120 * w_369 - w_122 * w_372 + w_124 * w_402 - w_126 * w_370)
            + w_381 * w_394 + w_410;
        let w_412 = w_374
            * (w_10_squared * (w_137 * w_370 - w_138 * w_372 + w_139 * w_378)
                + platform_q2 * w_404 + w_133 * w_369);
        let w_413 = c2_on_platform_z
            * (w_10_squared * (w_141 * w_372 - w_142 * w_370)
                + w_10 * (platform_q3_dot * w_373 - platform_q0_dot * w_369)
                + platform_q2 * w_406);
        let w_414 = w_379 * w_396
            + w_371 * (w_132 * w_370 + w_133 * w_373 - w_135 * w_372 + w_136 * w_401)
            + w_380 * w_397 + w_412 + w_381 * w_398 + w_413;
        let w_415 = w_374
            * (w_146 * w_369 - w_150 * w_372 + w_151 * w_402 - w_152 * w_370);
        let w_416 = c2_on_platform_z
            * (w_10_squared * (w_154 * w_372 - w_155 * w_370)
                + w_10 * (platform_q2_dot * w_373 + platform_q1_dot * w_369)
                + platform_q3 * w_406);
        let w_417 = w_379 * w_383
            + w_371 * (w_145 * w_370 + w_146 * w_373 + w_147 * w_372 - w_149 * w_401)
            - w_380 * w_384 - w_415 - w_381 * w_386 - w_416;
        let w_418 = S::from_f64(2.0)
            * (w_382 * (w_400 / w_376_squared)
                + (platform_q0_dot * w_408 + platform_q1_dot * w_411
                    + platform_q2_dot * w_414 - platform_q3_dot * w_417) / w_376);
        let w_419 = w_418
            + (platform_x_dot * w_379 + platform_y_dot * w_380 + platform_z_dot * w_381)
                / w_376
            - w_382
                * ((platform_x_dot * w_371 + platform_y_dot * w_374
                    + platform_z_dot * c2_on_platform_z) / w_376_squared);
        [
            S::from_f64(2.0)
                * (platform_q0_dot * platform_q0_dot + platform_q1_dot * platform_q1_dot
                    + platform_q2_dot * platform_q2_dot
                    + platform_q3_dot * platform_q3_dot),
            w_31.sqrt() * w_159 + sin_w * (w_160 + w_161),
            w_169.sqrt() * w_212 + w_213 - w_214,
            w_222.sqrt() * w_265 + w_213 + w_214,
            w_273.sqrt() * w_316 + w_213 - w_317,
            w_325.sqrt() * w_368 + w_213 + w_317,
            w_376.sqrt() * w_419 + w_213 - w_161 * w_9,
        ]
    }
    /// `C` (7), `C_q` (7 x 7) and `C_t` (7) together, in SI units, for projection.
    ///
    /// Operations: 304 additions, 549 multiplications, 43 divisions, 16 sine-cosine pairs, 6 square roots.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 7],
    ) -> sim_kernel::ConstraintLinearization<[S; 7], [[S; 7]; 7]> {
        let [platform_x, platform_y, platform_z, platform_q0, platform_q1, platform_q2,
        platform_q3] = *q;
        let platform_q0_squared = platform_q0 * platform_q0;
        let platform_q1_squared = platform_q1 * platform_q1;
        let platform_q2_squared = platform_q2 * platform_q2;
        let platform_q3_squared = platform_q3 * platform_q3;
        let w = S::from_f64(0.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        let a1_head_angle = w - self.head;
        let w_2 = t * self.w;
        let w_3 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_3 - self.foot;
        let a2_head_angle = w + self.head;
        let w_4 = w_3 + w_2;
        let b1_foot_angle = w_3 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_5 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333);
        let b2_foot_angle = w_5 - self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let w_6 = w_5 + w_2;
        let c1_foot_angle = w_5 + self.foot;
        let w_7 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_7 - self.head;
        let w_8 = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI);
        let c2_foot_angle = w_8 - self.foot;
        let c2_head_angle = w_7 + self.head;
        let w_9 = w_8 + w_2;
        let (
            [sin_foot,
            sin_a1_head_angle,
            sin_w_2,
            sin_a2_foot_angle,
            sin_a2_head_angle,
            sin_w_4,
            sin_b1_foot_angle,
            sin_b1_head_angle,
            sin_b2_foot_angle,
            sin_b2_head_angle,
            sin_w_6,
            sin_c1_foot_angle,
            sin_c1_head_angle,
            sin_c2_foot_angle,
            sin_c2_head_angle,
            sin_w_9,
            ],
            [cos_foot,
            cos_a1_head_angle,
            cos_w_2,
            cos_a2_foot_angle,
            cos_a2_head_angle,
            cos_w_4,
            cos_b1_foot_angle,
            cos_b1_head_angle,
            cos_b2_foot_angle,
            cos_b2_head_angle,
            cos_w_6,
            cos_c1_foot_angle,
            cos_c1_head_angle,
            cos_c2_foot_angle,
            cos_c2_head_angle,
            cos_w_9,
            ],
        ) = S::sin_cos_each([
            self.foot,
            a1_head_angle,
            w_2,
            a2_foot_angle,
            a2_head_angle,
            w_4,
            b1_foot_angle,
            b1_head_angle,
            b2_foot_angle,
            b2_head_angle,
            w_6,
            c1_foot_angle,
            c1_head_angle,
            c2_foot_angle,
            c2_head_angle,
            w_9,
        ]);
        let w_10 = S::from_f64(1.0)
            / (platform_q0_squared + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_11 = platform_q2_squared + platform_q3_squared;
        let w_12 = S::from_f64(2.0) * w_10 * w_11 - S::from_f64(1.0);
        let w_13 = self.r * cos_a1_head_angle;
        let w_14 = self.r * S::from_f64(2.0);
        let w_15 = sin_a1_head_angle * w_14;
        let w_16 = platform_q1 * platform_q2;
        let w_17 = platform_q0 * platform_q3;
        let w_18 = w_16 - w_17;
        let w_19 = w_10 * w_18;
        let w_20 = platform_x - self.R * cos_foot - w_12 * w_13 + w_15 * w_19;
        let w_21 = cos_a1_head_angle * w_14;
        let w_22 = w_16 + w_17;
        let w_23 = w_10 * w_22;
        let w_24 = platform_q1_squared + platform_q3_squared;
        let w_25 = S::from_f64(2.0) * w_10 * w_24 - S::from_f64(1.0);
        let w_26 = self.r * sin_a1_head_angle;
        let w_27 = platform_y - self.R * sin_foot + w_21 * w_23 - w_25 * w_26;
        let w_28 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_29 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let w_30 = w_21 * w_28 + w_15 * w_29;
        let a1_on_platform_z = w_10 * w_30 + platform_z;
        let w_31 = w_20 * w_20 + w_27 * w_27 + a1_on_platform_z * a1_on_platform_z;
        let sqrt_w_31 = w_31.sqrt();
        let w_32 = self.r * cos_a2_head_angle;
        let w_33 = w_14 * sin_a2_head_angle;
        let w_34 = platform_x - self.R * cos_a2_foot_angle - w_12 * w_32 + w_19 * w_33;
        let w_35 = w_14 * cos_a2_head_angle;
        let w_36 = self.r * sin_a2_head_angle;
        let w_37 = platform_y - self.R * sin_a2_foot_angle + w_23 * w_35 - w_25 * w_36;
        let w_38 = w_28 * w_35 + w_29 * w_33;
        let a2_on_platform_z = w_10 * w_38 + platform_z;
        let w_39 = w_34 * w_34 + w_37 * w_37 + a2_on_platform_z * a2_on_platform_z;
        let sqrt_w_39 = w_39.sqrt();
        let w_40 = self.heave * sin_w_2;
        let w_41 = self.sway * sin_w_4;
        let w_42 = self.r * cos_b1_head_angle;
        let w_43 = w_14 * sin_b1_head_angle;
        let w_44 = platform_x - self.R * cos_b1_foot_angle - w_12 * w_42 + w_19 * w_43;
        let w_45 = w_14 * cos_b1_head_angle;
        let w_46 = self.r * sin_b1_head_angle;
        let w_47 = platform_y - self.R * sin_b1_foot_angle + w_23 * w_45 - w_25 * w_46;
        let w_48 = w_28 * w_45 + w_29 * w_43;
        let b1_on_platform_z = w_10 * w_48 + platform_z;
        let w_49 = w_44 * w_44 + w_47 * w_47 + b1_on_platform_z * b1_on_platform_z;
        let sqrt_w_49 = w_49.sqrt();
        let w_50 = self.r * cos_b2_head_angle;
        let w_51 = w_14 * sin_b2_head_angle;
        let w_52 = platform_x - self.R * cos_b2_foot_angle - w_12 * w_50 + w_19 * w_51;
        let w_53 = w_14 * cos_b2_head_angle;
        let w_54 = self.r * sin_b2_head_angle;
        let w_55 = platform_y - self.R * sin_b2_foot_angle + w_23 * w_53 - w_25 * w_54;
        let w_56 = w_28 * w_53 + w_29 * w_51;
        let b2_on_platform_z = w_10 * w_56 + platform_z;
        let w_57 = w_52 * w_52 + w_55 * w_55 + b2_on_platform_z * b2_on_platform_z;
        let sqrt_w_57 = w_57.sqrt();
        let w_58 = self.sway * sin_w_6;
        let w_59 = self.r * cos_c1_head_angle;
        let w_60 = w_14 * sin_c1_head_angle;
        let w_61 = platform_x - self.R * cos_c1_foot_angle - w_12 * w_59 + w_19 * w_60;
        let w_62 = w_14 * cos_c1_head_angle;
        let w_63 = self.r * sin_c1_head_angle;
        let w_64 = platform_y - self.R * sin_c1_foot_angle + w_23 * w_62 - w_25 * w_63;
        let w_65 = w_28 * w_62 + w_29 * w_60;
        let c1_on_platform_z = w_10 * w_65 + platform_z;
        let w_66 = w_61 * w_61 + w_64 * w_64 + c1_on_platform_z * c1_on_platform_z;
        let sqrt_w_66 = w_66.sqrt();
        let w_67 = self.r * cos_c2_head_angle;
        let w_68 = w_14 * sin_c2_head_angle;
        let w_69 = platform_x - self.R * cos_c2_foot_angle - w_12 * w_67 + w_19 * w_68;
        let w_70 = w_14 * cos_c2_head_angle;
        let w_71 = self.r * sin_c2_head_angle;
        let w_72 = platform_y - self.R * sin_c2_foot_angle + w_23 * w_70 - w_25 * w_71;
        let w_73 = w_28 * w_70 + w_29 * w_68;
        let c2_on_platform_z = w_10 * w_73 + platform_z;
        let w_74 = w_69 * w_69 + w_72 * w_72 + c2_on_platform_z * c2_on_platform_z;
        let sqrt_w_74 = w_74.sqrt();
        let w_10_squared = w_10 * w_10;
        let w_75 = w_10_squared * (w_11 * w_21 - w_18 * w_15);
        let w_76 = platform_q3 * w_10;
        let w_77 = w_10_squared * (w_15 * w_24 - w_22 * w_21);
        let w_78 = w_30 * w_10_squared;
        let w_79 = a1_on_platform_z
            * (platform_q0 * w_78 + w_10 * (platform_q2 * w_13 - platform_q1 * w_26));
        let w_80 = platform_q2 * w_10;
        let w_81 = w_10_squared * platform_q1 * w_22;
        let w_82 = w_10 - w_24 * w_10_squared;
        let w_83 = platform_q1 * w_82;
        let w_84 = a1_on_platform_z
            * (w_10 * (platform_q3 * w_13 + platform_q0 * w_26) - platform_q1 * w_78);
        let w_85 = platform_q1 * w_10;
        let w_86 = w_10 - w_11 * w_10_squared;
        let w_87 = platform_q2 * w_86;
        let w_88 = w_10_squared * platform_q2 * w_18;
        let w_89 = a1_on_platform_z
            * (w_10 * (platform_q3 * w_26 - platform_q0 * w_13) - platform_q2 * w_78);
        let w_90 = platform_q0 * w_10;
        let w_91 = platform_q3 * w_86;
        let w_92 = platform_q3 * w_10_squared;
        let w_93 = w_18 * w_92;
        let w_94 = w_22 * w_92;
        let w_95 = platform_q3 * w_82;
        let w_96 = a1_on_platform_z
            * (w_10 * (platform_q2 * w_26 + platform_q1 * w_13) - platform_q3 * w_78);
        let w_97 = S::from_f64(2.0) * sqrt_w_31
            * (w_20 * (w_26 * w_90 + w_21 * w_91 + w_15 * w_93)
                - w_27 * (w_13 * w_90 - w_21 * w_94 - w_15 * w_95) - w_96);
        let w_98 = w_10_squared * (w_11 * w_35 - w_18 * w_33);
        let w_99 = w_10_squared * (w_24 * w_33 - w_22 * w_35);
        let w_100 = w_38 * w_10_squared;
        let w_101 = a2_on_platform_z
            * (platform_q0 * w_100 + w_10 * (platform_q2 * w_32 - platform_q1 * w_36));
        let w_102 = a2_on_platform_z
            * (w_10 * (platform_q3 * w_32 + platform_q0 * w_36) - platform_q1 * w_100);
        let w_103 = a2_on_platform_z
            * (w_10 * (platform_q3 * w_36 - platform_q0 * w_32) - platform_q2 * w_100);
        let w_104 = a2_on_platform_z
            * (w_10 * (platform_q2 * w_36 + platform_q1 * w_32) - platform_q3 * w_100);
        let w_105 = S::from_f64(2.0) * sqrt_w_39
            * (w_34 * (w_36 * w_90 + w_35 * w_91 + w_33 * w_93)
                - w_37 * (w_32 * w_90 - w_35 * w_94 - w_33 * w_95) - w_104);
        let w_106 = w_10_squared * (w_11 * w_45 - w_18 * w_43);
        let w_107 = w_10_squared * (w_24 * w_43 - w_22 * w_45);
        let w_108 = w_48 * w_10_squared;
        let w_109 = b1_on_platform_z
            * (platform_q0 * w_108 + w_10 * (platform_q2 * w_42 - platform_q1 * w_46));
        let w_110 = b1_on_platform_z
            * (w_10 * (platform_q3 * w_42 + platform_q0 * w_46) - platform_q1 * w_108);
        let w_111 = b1_on_platform_z
            * (w_10 * (platform_q3 * w_46 - platform_q0 * w_42) - platform_q2 * w_108);
        let w_112 = b1_on_platform_z
            * (w_10 * (platform_q2 * w_46 + platform_q1 * w_42) - platform_q3 * w_108);
        let w_113 = S::from_f64(2.0) * sqrt_w_49
            * (w_44 * (w_46 * w_90 + w_45 * w_91 + w_43 * w_93)
                - w_47 * (w_42 * w_90 - w_45 * w_94 - w_43 * w_95) - w_112);
        let w_114 = w_10_squared * (w_11 * w_53 - w_18 * w_51);
        let w_115 = w_10_squared * (w_24 * w_51 - w_22 * w_53);
        let w_116 = w_56 * w_10_squared;
        let w_117 = b2_on_platform_z
            * (platform_q0 * w_116 + w_10 * (platform_q2 * w_50 - platform_q1 * w_54));
        let w_118 = b2_on_platform_z
            * (w_10 * (platform_q3 * w_50 + platform_q0 * w_54) - platform_q1 * w_116);
        let w_119 = b2_on_platform_z
            * (w_10 * (platform_q3 * w_54 - platform_q0 * w_50) - platform_q2 * w_116);
        let w_120 = b2_on_platform_z
            * (w_10 * (platform_q2 * w_54 + platform_q1 * w_50) - platform_q3 * w_116);
        let w_121 = S::from_f64(2.0) * sqrt_w_57
            * (w_52 * (w_54 * w_90 + w_53 * w_91 + w_51 * w_93)
                - w_55 * (w_50 * w_90 - w_53 * w_94 - w_51 * w_95) - w_120);
        let w_122 = w_10_squared * (w_11 * w_62 - w_18 * w_60);
        let w_123 = w_10_squared * (w_24 * w_60 - w_22 * w_62);
        let w_124 = w_65 * w_10_squared;
        let w_125 = c1_on_platform_z
            * (platform_q0 * w_124 + w_10 * (platform_q2 * w_59 - platform_q1 * w_63));
        let w_126 = c1_on_platform_z
            * (w_10 * (platform_q3 * w_59 + platform_q0 * w_63) - platform_q1 * w_124);
        let w_127 = c1_on_platform_z
            * (w_10 * (platform_q3 * w_63 - platform_q0 * w_59) - platform_q2 * w_124);
        let w_128 = c1_on_platform_z
            * (w_10 * (platform_q2 * w_63 + platform_q1 * w_59) - platform_q3 * w_124);
        let w_129 = S::from_f64(2.0) * sqrt_w_66
            * (w_61 * (w_63 * w_90 + w_62 * w_91 + w_60 * w_93)
                - w_64 * (w_59 * w_90 - w_62 * w_94 - w_60 * w_95) - w_128);
        let w_130 = w_10_squared * (w_11 * w_70 - w_18 * w_68);
        let w_131 = w_10_squared * (w_24 * w_68 - w_22 * w_70);
        let w_132 = w_73 * w_10_squared;
        let w_133 = c2_on_platform_z
            * (platform_q0 * w_132 + w_10 * (platform_q2 * w_67 - platform_q1 * w_71));
        let w_134 = c2_on_platform_z
            * (w_10 * (platform_q3 * w_67 + platform_q0 * w_71) - platform_q1 * w_132);
        let w_135 = c2_on_platform_z
            * (w_10 * (platform_q3 * w_71 - platform_q0 * w_67) - platform_q2 * w_132);
        let w_136 = c2_on_platform_z
            * (w_10 * (platform_q2 * w_71 + platform_q1 * w_67) - platform_q3 * w_132);
        let w_137 = S::from_f64(2.0) * sqrt_w_74
            * (w_69 * (w_71 * w_90 + w_70 * w_91 + w_68 * w_93)
                - w_72 * (w_67 * w_90 - w_70 * w_94 - w_68 * w_95) - w_136);
        let w_138 = self.heave * self.w;
        let w_139 = self.w * self.sway;
        let w_140 = w_139 * cos_w_4;
        let w_141 = cos_w_2 * w_138;
        let w_142 = w_139 * cos_w_6;
        sim_kernel::ConstraintLinearization {
            values: [
                platform_q0_squared + platform_q1_squared + platform_q2_squared
                    + platform_q3_squared - S::from_f64(1.0),
                sqrt_w_31 - self.L - sin_w_2 * (self.heave + self.sway),
                sqrt_w_39 - self.L - w_40 + w_41,
                sqrt_w_49 - self.L - w_40 - w_41,
                sqrt_w_57 - self.L - w_40 + w_58,
                sqrt_w_66 - self.L - w_40 - w_58,
                sqrt_w_74 - self.L - w_40 + self.sway * sin_w_9,
            ],
            jacobian: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    platform_q0 * S::from_f64(2.0),
                    platform_q1 * S::from_f64(2.0),
                    platform_q2 * S::from_f64(2.0),
                    platform_q3 * S::from_f64(2.0),
                ],
                [
                    w_20 * sqrt_w_31 / w_31,
                    w_27 * sqrt_w_31 / w_31,
                    a1_on_platform_z * sqrt_w_31 / w_31,
                    S::from_f64(2.0) * sqrt_w_31
                        * (w_20 * (platform_q0 * w_75 - w_26 * w_76)
                            + w_27 * (platform_q0 * w_77 + w_13 * w_76) - w_79) / w_31,
                    S::from_f64(2.0) * sqrt_w_31
                        * (w_20 * (platform_q1 * w_75 + w_26 * w_80)
                            + w_27 * (w_13 * w_80 - w_21 * w_81 - w_15 * w_83) + w_84)
                        / w_31,
                    S::from_f64(2.0) * sqrt_w_31
                        * (w_20 * (w_26 * w_85 - w_21 * w_87 - w_15 * w_88)
                            + w_27 * (platform_q2 * w_77 + w_13 * w_85) + w_89) / w_31,
                    -(w_97 / w_31),
                ],
                [
                    w_34 * sqrt_w_39 / w_39,
                    w_37 * sqrt_w_39 / w_39,
                    a2_on_platform_z * sqrt_w_39 / w_39,
                    S::from_f64(2.0) * sqrt_w_39
                        * (w_34 * (platform_q0 * w_98 - w_36 * w_76)
                            + w_37 * (platform_q0 * w_99 + w_32 * w_76) - w_101) / w_39,
                    S::from_f64(2.0) * sqrt_w_39
                        * (w_34 * (platform_q1 * w_98 + w_36 * w_80)
                            + w_37 * (w_32 * w_80 - w_35 * w_81 - w_33 * w_83) + w_102)
                        / w_39,
                    S::from_f64(2.0) * sqrt_w_39
                        * (w_34 * (w_36 * w_85 - w_35 * w_87 - w_33 * w_88)
                            + w_37 * (platform_q2 * w_99 + w_32 * w_85) + w_103) / w_39,
                    -(w_105 / w_39),
                ],
                [
                    w_44 * sqrt_w_49 / w_49,
                    w_47 * sqrt_w_49 / w_49,
                    b1_on_platform_z * sqrt_w_49 / w_49,
                    S::from_f64(2.0) * sqrt_w_49
                        * (w_44 * (platform_q0 * w_106 - w_46 * w_76)
                            + w_47 * (platform_q0 * w_107 + w_42 * w_76) - w_109) / w_49,
                    S::from_f64(2.0) * sqrt_w_49
                        * (w_44 * (platform_q1 * w_106 + w_46 * w_80)
                            + w_47 * (w_42 * w_80 - w_45 * w_81 - w_43 * w_83) + w_110)
                        / w_49,
                    S::from_f64(2.0) * sqrt_w_49
                        * (w_44 * (w_46 * w_85 - w_45 * w_87 - w_43 * w_88)
                            + w_47 * (platform_q2 * w_107 + w_42 * w_85) + w_111) / w_49,
                    -(w_113 / w_49),
                ],
                [
                    w_52 * sqrt_w_57 / w_57,
                    w_55 * sqrt_w_57 / w_57,
                    b2_on_platform_z * sqrt_w_57 / w_57,
                    S::from_f64(2.0) * sqrt_w_57
                        * (w_52 * (platform_q0 * w_114 - w_54 * w_76)
                            + w_55 * (platform_q0 * w_115 + w_50 * w_76) - w_117) / w_57,
                    S::from_f64(2.0) * sqrt_w_57
                        * (w_52 * (platform_q1 * w_114 + w_54 * w_80)
                            + w_55 * (w_50 * w_80 - w_53 * w_81 - w_51 * w_83) + w_118)
                        / w_57,
                    S::from_f64(2.0) * sqrt_w_57
                        * (w_52 * (w_54 * w_85 - w_53 * w_87 - w_51 * w_88)
                            + w_55 * (platform_q2 * w_115 + w_50 * w_85) + w_119) / w_57,
                    -(w_121 / w_57),
                ],
                [
                    w_61 * sqrt_w_66 / w_66,
                    w_64 * sqrt_w_66 / w_66,
                    c1_on_platform_z * sqrt_w_66 / w_66,
                    S::from_f64(2.0) * sqrt_w_66
                        * (w_61 * (platform_q0 * w_122 - w_63 * w_76)
                            + w_64 * (platform_q0 * w_123 + w_59 * w_76) - w_125) / w_66,
                    S::from_f64(2.0) * sqrt_w_66
                        * (w_61 * (platform_q1 * w_122 + w_63 * w_80)
                            + w_64 * (w_59 * w_80 - w_62 * w_81 - w_60 * w_83) + w_126)
                        / w_66,
                    S::from_f64(2.0) * sqrt_w_66
                        * (w_61 * (w_63 * w_85 - w_62 * w_87 - w_60 * w_88)
                            + w_64 * (platform_q2 * w_123 + w_59 * w_85) + w_127) / w_66,
                    -(w_129 / w_66),
                ],
                [
                    w_69 * sqrt_w_74 / w_74,
                    w_72 * sqrt_w_74 / w_74,
                    c2_on_platform_z * sqrt_w_74 / w_74,
                    S::from_f64(2.0) * sqrt_w_74
                        * (w_69 * (platform_q0 * w_130 - w_71 * w_76)
                            + w_72 * (platform_q0 * w_131 + w_67 * w_76) - w_133) / w_74,
                    S::from_f64(2.0) * sqrt_w_74
                        * (w_69 * (platform_q1 * w_130 + w_71 * w_80)
                            + w_72 * (w_67 * w_80 - w_70 * w_81 - w_68 * w_83) + w_134)
                        / w_74,
                    S::from_f64(2.0) * sqrt_w_74
                        * (w_69 * (w_71 * w_85 - w_70 * w_87 - w_68 * w_88)
                            + w_72 * (platform_q2 * w_131 + w_67 * w_85) + w_135) / w_74,
                    -(w_137 / w_74),
                ],
            ],
            time_derivative: [
                S::from_f64(0.0),
                -(cos_w_2 * (w_138 + w_139)),
                w_140 - w_141,
                -(w_141 + w_140),
                w_142 - w_141,
                -(w_141 + w_142),
                w_139 * cos_w_9 - w_141,
            ],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 22 additions, 37 multiplications, 1 division.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> S {
        let [_, _, _, platform_q0, platform_q1, platform_q2, platform_q3] = *q;
        let [platform_x_dot, platform_y_dot, platform_z_dot, platform_q0_dot,
        platform_q1_dot, platform_q2_dot, platform_q3_dot] = *qd;
        let w = S::from_f64(1.0)
            / (platform_q0 * platform_q0 + platform_q1 * platform_q1
                + platform_q2 * platform_q2 + platform_q3 * platform_q3);
        let w_2 = S::from_f64(2.0) * self.A;
        let w_3 = platform_q0 * platform_q1_dot - platform_q1 * platform_q0_dot
            - platform_q2 * platform_q3_dot + platform_q3 * platform_q2_dot;
        let w_4 = platform_q0 * platform_q2_dot - platform_q2 * platform_q0_dot
            - platform_q3 * platform_q1_dot + platform_q1 * platform_q3_dot;
        let w_5 = platform_q0 * platform_q3_dot - platform_q3 * platform_q0_dot
            - platform_q1 * platform_q2_dot + platform_q2 * platform_q1_dot;
        let w_6 = w * w
            * (w_2 * (w_3 * w_3 + w_4 * w_4) + w_5 * w_5 * S::from_f64(2.0) * self.C);
        let w_7 = platform_q0 * platform_q0_dot + platform_q1 * platform_q1_dot
            + platform_q2 * platform_q2_dot + platform_q3 * platform_q3_dot;
        S::from_f64(0.5) * self.m
            * (platform_x_dot * platform_x_dot + platform_y_dot * platform_y_dot
                + platform_z_dot * platform_z_dot) + w_6
            + w_7 * w_7 * S::from_f64(0.6666666666666666) * (w_2 + self.C)
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 16 additions, 19 multiplications, 4 sine-cosine pairs.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 7],
    ) -> S {
        let [_, _, platform_z_dot, _, _, _, _] = *qd;
        let [_, lambda_a1_leg, lambda_a2_leg, lambda_b1_leg, lambda_b2_leg,
        lambda_c1_leg, lambda_c2_leg] = *lambda;
        let w = self.w * t;
        let ([_, _, _, _], [cos_w, w_2, w_3, w_4]) = S::sin_cos_each([
            w,
            S::from_f64(0.6666666666666666) * S::from_f64(::core::f64::consts::PI) + w,
            S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333) + w,
            S::from_f64(::core::f64::consts::PI) * S::from_f64(2.0) + w,
        ]);
        let w_5 = self.heave * self.w;
        let w_6 = self.w * self.sway;
        let w_7 = cos_w * w_5;
        let w_8 = w_6 * w_2;
        let w_9 = w_6 * w_3;
        let w_10 = lambda_c2_leg * (w_7 - w_6 * w_4);
        let w_11 = platform_z_dot * self.m * self.g + lambda_a1_leg * cos_w * (w_5 + w_6)
            + lambda_a2_leg * (w_7 - w_8) + lambda_b1_leg * (w_7 + w_8)
            + lambda_b2_leg * (w_7 - w_9) + lambda_c1_leg * (w_7 + w_9) + w_10;
        -w_11
    }
    /// Outputs, 4, in SI units.
    ///
    /// Operations: 5 additions, 6 multiplications, 1 division.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 7],
    ) -> StewartOutputs<S> {
        let [_, _, platform_z, platform_q0, platform_q1, platform_q2, platform_q3] = *q;
        let [_, lambda_a1_leg, lambda_a2_leg, _, _, _, _] = *lambda;
        let platform_q1_squared = platform_q1 * platform_q1;
        let platform_q2_squared = platform_q2 * platform_q2;
        [
            platform_z,
            S::from_f64(1.0)
                - S::from_f64(2.0)
                    * (S::from_f64(1.0)
                        / (platform_q0 * platform_q0 + platform_q1_squared
                            + platform_q2_squared + platform_q3 * platform_q3))
                    * (platform_q1_squared + platform_q2_squared),
            lambda_a1_leg,
            lambda_a2_leg,
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 2, in SI units per second.
    ///
    /// Operations: 9 additions, 13 multiplications, 1 division.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
    ) -> StewartOutputRates<S> {
        let [_, _, _, platform_q0, platform_q1, platform_q2, platform_q3] = *q;
        let [_, _, platform_z_dot, platform_q0_dot, platform_q1_dot, platform_q2_dot,
        platform_q3_dot] = *qd;
        let platform_q1_squared = platform_q1 * platform_q1;
        let platform_q2_squared = platform_q2 * platform_q2;
        let w = S::from_f64(1.0)
            / (platform_q0 * platform_q0 + platform_q1_squared + platform_q2_squared
                + platform_q3 * platform_q3);
        let w_2 = platform_q1 * platform_q1_dot;
        let w_3 = platform_q2 * platform_q2_dot;
        [
            platform_z_dot,
            S::from_f64(4.0)
                * (w * w * (platform_q1_squared + platform_q2_squared)
                    * (platform_q0 * platform_q0_dot + w_2 + w_3
                        + platform_q3 * platform_q3_dot) - w * (w_2 + w_3)),
        ]
            .into()
    }
    /// `left - right` of each event, 1, in SI units: zero when it happens.
    ///
    /// Operations: 2 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 7],
    ) -> [S; 1] {
        let ([w], [_]) = S::sin_cos_each([t * S::from_f64(0.5) * self.w]);
        [w]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 58 additions, 100 multiplications, 1 division, 12 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 7]) -> [S; 75] {
        let [platform_x, platform_y, platform_z, platform_q0, platform_q1, platform_q2,
        platform_q3] = *q;
        let w = S::from_f64(0.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        let a1_head_angle = w - self.head;
        let w_2 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_2 - self.foot;
        let a2_head_angle = w + self.head;
        let b1_foot_angle = w_2 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_3 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333);
        let b2_foot_angle = w_3 - self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let c1_foot_angle = w_3 + self.foot;
        let w_4 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_4 - self.head;
        let c2_foot_angle = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI)
            - self.foot;
        let c2_head_angle = w_4 + self.head;
        let (
            [sin_foot,
            sin_a1_head_angle,
            sin_a2_foot_angle,
            sin_a2_head_angle,
            sin_b1_foot_angle,
            sin_b1_head_angle,
            sin_b2_foot_angle,
            sin_b2_head_angle,
            sin_c1_foot_angle,
            sin_c1_head_angle,
            sin_c2_foot_angle,
            sin_c2_head_angle,
            ],
            [cos_foot,
            cos_a1_head_angle,
            cos_a2_foot_angle,
            cos_a2_head_angle,
            cos_b1_foot_angle,
            cos_b1_head_angle,
            cos_b2_foot_angle,
            cos_b2_head_angle,
            cos_c1_foot_angle,
            cos_c1_head_angle,
            cos_c2_foot_angle,
            cos_c2_head_angle,
            ],
        ) = S::sin_cos_each([
            self.foot,
            a1_head_angle,
            a2_foot_angle,
            a2_head_angle,
            b1_foot_angle,
            b1_head_angle,
            b2_foot_angle,
            b2_head_angle,
            c1_foot_angle,
            c1_head_angle,
            c2_foot_angle,
            c2_head_angle,
        ]);
        let a1_on_ground_x = self.R * cos_foot;
        let a1_on_ground_y = self.R * sin_foot;
        let platform_q1_squared = platform_q1 * platform_q1;
        let platform_q2_squared = platform_q2 * platform_q2;
        let platform_q3_squared = platform_q3 * platform_q3;
        let w_5 = S::from_f64(1.0)
            / (platform_q0 * platform_q0 + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_6 = S::from_f64(2.0) * w_5 * (platform_q2_squared + platform_q3_squared)
            - S::from_f64(1.0);
        let w_7 = self.r * S::from_f64(2.0);
        let w_8 = sin_a1_head_angle * w_7;
        let w_9 = platform_q1 * platform_q2;
        let w_10 = platform_q0 * platform_q3;
        let w_11 = w_5 * (w_9 - w_10);
        let a1_on_platform_x = platform_x - w_6 * self.r * cos_a1_head_angle
            + w_8 * w_11;
        let w_12 = cos_a1_head_angle * w_7;
        let w_13 = w_5 * (w_9 + w_10);
        let w_14 = S::from_f64(2.0) * w_5 * (platform_q1_squared + platform_q3_squared)
            - S::from_f64(1.0);
        let a1_on_platform_y = platform_y + w_12 * w_13
            - w_14 * self.r * sin_a1_head_angle;
        let w_15 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_16 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let a1_on_platform_z = w_5 * (w_12 * w_15 + w_8 * w_16) + platform_z;
        let a2_on_ground_x = self.R * cos_a2_foot_angle;
        let a2_on_ground_y = self.R * sin_a2_foot_angle;
        let w_17 = w_7 * sin_a2_head_angle;
        let a2_on_platform_x = platform_x - w_6 * self.r * cos_a2_head_angle
            + w_11 * w_17;
        let w_18 = w_7 * cos_a2_head_angle;
        let a2_on_platform_y = platform_y + w_13 * w_18
            - w_14 * self.r * sin_a2_head_angle;
        let a2_on_platform_z = w_5 * (w_15 * w_18 + w_16 * w_17) + platform_z;
        let b1_on_ground_x = self.R * cos_b1_foot_angle;
        let b1_on_ground_y = self.R * sin_b1_foot_angle;
        let w_19 = w_7 * sin_b1_head_angle;
        let b1_on_platform_x = platform_x - w_6 * self.r * cos_b1_head_angle
            + w_11 * w_19;
        let w_20 = w_7 * cos_b1_head_angle;
        let b1_on_platform_y = platform_y + w_13 * w_20
            - w_14 * self.r * sin_b1_head_angle;
        let b1_on_platform_z = w_5 * (w_15 * w_20 + w_16 * w_19) + platform_z;
        let b2_on_ground_x = self.R * cos_b2_foot_angle;
        let b2_on_ground_y = self.R * sin_b2_foot_angle;
        let w_21 = w_7 * sin_b2_head_angle;
        let b2_on_platform_x = platform_x - w_6 * self.r * cos_b2_head_angle
            + w_11 * w_21;
        let w_22 = w_7 * cos_b2_head_angle;
        let b2_on_platform_y = platform_y + w_13 * w_22
            - w_14 * self.r * sin_b2_head_angle;
        let b2_on_platform_z = w_5 * (w_15 * w_22 + w_16 * w_21) + platform_z;
        let c1_on_ground_x = self.R * cos_c1_foot_angle;
        let c1_on_ground_y = self.R * sin_c1_foot_angle;
        let w_23 = w_7 * sin_c1_head_angle;
        let c1_on_platform_x = platform_x - w_6 * self.r * cos_c1_head_angle
            + w_11 * w_23;
        let w_24 = w_7 * cos_c1_head_angle;
        let c1_on_platform_y = platform_y + w_13 * w_24
            - w_14 * self.r * sin_c1_head_angle;
        let c1_on_platform_z = w_5 * (w_15 * w_24 + w_16 * w_23) + platform_z;
        let c2_on_ground_x = self.R * cos_c2_foot_angle;
        let c2_on_ground_y = self.R * sin_c2_foot_angle;
        let w_25 = w_7 * sin_c2_head_angle;
        let c2_on_platform_x = platform_x - w_6 * self.r * cos_c2_head_angle
            + w_11 * w_25;
        let w_26 = w_7 * cos_c2_head_angle;
        let c2_on_platform_y = platform_y + w_13 * w_26
            - w_14 * self.r * sin_c2_head_angle;
        let c2_on_platform_z = w_5 * (w_15 * w_26 + w_16 * w_25) + platform_z;
        [
            a1_on_ground_x,
            a1_on_ground_y,
            S::from_f64(0.0),
            a1_on_platform_x,
            a1_on_platform_y,
            a1_on_platform_z,
            a2_on_ground_x,
            a2_on_ground_y,
            S::from_f64(0.0),
            a2_on_platform_x,
            a2_on_platform_y,
            a2_on_platform_z,
            b1_on_ground_x,
            b1_on_ground_y,
            S::from_f64(0.0),
            b1_on_platform_x,
            b1_on_platform_y,
            b1_on_platform_z,
            b2_on_ground_x,
            b2_on_ground_y,
            S::from_f64(0.0),
            b2_on_platform_x,
            b2_on_platform_y,
            b2_on_platform_z,
            c1_on_ground_x,
            c1_on_ground_y,
            S::from_f64(0.0),
            c1_on_platform_x,
            c1_on_platform_y,
            c1_on_platform_z,
            c2_on_ground_x,
            c2_on_ground_y,
            S::from_f64(0.0),
            c2_on_platform_x,
            c2_on_platform_y,
            c2_on_platform_z,
            a1_on_ground_x,
            a1_on_ground_y,
            S::from_f64(0.0),
            a2_on_ground_x,
            a2_on_ground_y,
            S::from_f64(0.0),
            b1_on_ground_x,
            b1_on_ground_y,
            S::from_f64(0.0),
            b2_on_ground_x,
            b2_on_ground_y,
            S::from_f64(0.0),
            c1_on_ground_x,
            c1_on_ground_y,
            S::from_f64(0.0),
            c2_on_ground_x,
            c2_on_ground_y,
            S::from_f64(0.0),
            a1_on_platform_x,
            a1_on_platform_y,
            a1_on_platform_z,
            a2_on_platform_x,
            a2_on_platform_y,
            a2_on_platform_z,
            b1_on_platform_x,
            b1_on_platform_y,
            b1_on_platform_z,
            b2_on_platform_x,
            b2_on_platform_y,
            b2_on_platform_z,
            c1_on_platform_x,
            c1_on_platform_y,
            c1_on_platform_z,
            c2_on_platform_x,
            c2_on_platform_y,
            c2_on_platform_z,
            a1_on_platform_x,
            a1_on_platform_y,
            a1_on_platform_z,
        ]
    }
    /// Declared start: values or guesses of the coordinates (7), and speeds (7), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 7]> {
        sim_kernel::Initial {
            positions: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.7),
                S::from_f64(1.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            speeds: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
        }
    }
    /// [`StewartPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::Dynamics<S, [S; 7], [S; 7]> {
        self.prepare().dynamics(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> StewartPrepared<S> {
    /// Accelerations (7), multipliers (7) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 1326 additions, 2128 multiplications, 78 divisions, 4 sine-cosine pairs, 6 square roots.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::Dynamics<S, [S; 7], [S; 7]> {
        let [platform_x, platform_y, platform_z, platform_q0, platform_q1, platform_q2,
        platform_q3] = *q;
        let [platform_x_dot, platform_y_dot, platform_z_dot, platform_q0_dot,
        platform_q1_dot, platform_q2_dot, platform_q3_dot] = *qd;
        let platform_q0_squared = platform_q0 * platform_q0;
        let platform_q1_squared = platform_q1 * platform_q1;
        let platform_q2_squared = platform_q2 * platform_q2;
        let platform_q3_squared = platform_q3 * platform_q3;
        let w = S::from_f64(1.0)
            / (platform_q0_squared + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_squared = w * w;
        let w_2 = platform_q0 * platform_q2_dot;
        let w_3 = platform_q2 * platform_q0_dot;
        let w_4 = platform_q3 * platform_q1_dot;
        let w_5 = platform_q1 * platform_q3_dot;
        let w_6 = w_2 - w_3 - w_4 + w_5;
        let w_7 = platform_q0 * platform_q3_dot;
        let w_8 = platform_q3 * platform_q0_dot;
        let w_9 = platform_q1 * platform_q2_dot;
        let w_10 = platform_q2 * platform_q1_dot;
        let w_11 = w_7 - w_8 - w_9 + w_10;
        let w_12 = platform_q0 * platform_q1_dot;
        let w_13 = platform_q1 * platform_q0_dot;
        let w_14 = platform_q2 * platform_q3_dot;
        let w_15 = platform_q3 * platform_q2_dot;
        let w_16 = w_12 - w_13 - w_14 + w_15;
        let w_17 = platform_q1 * platform_q1_dot;
        let w_18 = platform_q2 * platform_q2_dot;
        let w_19 = platform_q3 * platform_q3_dot;
        let w_20 = platform_q0 * platform_q0_dot + w_17 + w_18 + w_19;
        let w_21 = self.A * w_20;
        let w_22 = w_squared * (w_6 * w_11 * self.k_45 - w_16 * w_21);
        let w_23 = w_squared * (w_11 * w_16 * self.k_46 - w_6 * w_21);
        let w_24 = w * w_squared;
        let w_25 = self.k_47 * w_11 * w_20;
        let w_26 = platform_q0_dot * platform_q0_dot + platform_q1_dot * platform_q1_dot
            + platform_q2_dot * platform_q2_dot + platform_q3_dot * platform_q3_dot;
        let rhs_platform_q0 = S::from_f64(8.0) * w
            * (platform_q1 * w_22 + platform_q2 * w_23) - platform_q3 * w_24 * w_25
            - platform_q0 * self.k_3 * w_26;
        let w_27 = self.k_3 - w_squared * self.k;
        let w_28 = platform_q2 * platform_q3;
        let mass_platform_q1_platform_q0 = platform_q1 * platform_q0 * w_27
            + w_squared * self.k_4 * w_28;
        let w_29 = self.k * (platform_q1_squared + platform_q2_squared);
        let mass_platform_q0_platform_q0 = w_squared
            * (w_29 + platform_q3_squared * self.k_2) + platform_q0_squared * self.k_3;
        let inverse_platform_q0 = S::from_f64(1.0) / mass_platform_q0_platform_q0;
        let l_platform_q1_platform_q0 = mass_platform_q1_platform_q0
            * inverse_platform_q0;
        let rhs_platform_q1 = S::from_f64(8.0) * w
            * (platform_q3 * w_23 - platform_q0 * w_22) + platform_q2 * w_24 * w_25
            - platform_q1 * self.k_3 * w_26
            - rhs_platform_q0 * l_platform_q1_platform_q0;
        let w_30 = self.k_3 - w_squared * self.k_2;
        let mass_platform_q3_platform_q0 = platform_q0 * platform_q3 * w_30;
        let l_platform_q3_platform_q0 = mass_platform_q3_platform_q0
            * inverse_platform_q0;
        let w_31 = self.k * (platform_q0_squared + platform_q3_squared);
        let mass_platform_q1_platform_q1 = w_squared
            * (w_31 + platform_q2_squared * self.k_2) + platform_q1_squared * self.k_3;
        let pivot_platform_q1 = mass_platform_q1_platform_q1
            - mass_platform_q1_platform_q0 * l_platform_q1_platform_q0;
        let inverse_platform_q1 = S::from_f64(1.0) / pivot_platform_q1;
        let w_32 = platform_q0 * platform_q2;
        let k_platform_q3_platform_q1 = platform_q1 * platform_q3 * w_27
            + w_squared * self.k_5 * w_32
            - mass_platform_q1_platform_q0 * l_platform_q3_platform_q0;
        let l_platform_q3_platform_q1 = inverse_platform_q1 * k_platform_q3_platform_q1;
        let mass_platform_q2_platform_q2 = w_squared
            * (w_31 + platform_q1_squared * self.k_2) + platform_q2_squared * self.k_3;
        let w_33 = platform_q1 * platform_q3;
        let mass_platform_q2_platform_q0 = w_squared * (self.k_5 * w_33 - self.k * w_32)
            + self.k_3 * w_32;
        let l_platform_q2_platform_q0 = mass_platform_q2_platform_q0
            * inverse_platform_q0;
        let k_platform_q2_platform_q1 = platform_q1 * platform_q2 * w_30
            - mass_platform_q1_platform_q0 * l_platform_q2_platform_q0;
        let l_platform_q2_platform_q1 = inverse_platform_q1 * k_platform_q2_platform_q1;
        let pivot_platform_q2 = mass_platform_q2_platform_q2
            - mass_platform_q2_platform_q0 * l_platform_q2_platform_q0
            - k_platform_q2_platform_q1 * l_platform_q2_platform_q1;
        let inverse_platform_q2 = S::from_f64(1.0) / pivot_platform_q2;
        let w_34 = platform_q1 * platform_q0;
        let k_platform_q3_platform_q2 = w_squared * (self.k_4 * w_34 - self.k * w_28)
            + self.k_3 * w_28 - mass_platform_q2_platform_q0 * l_platform_q3_platform_q0
            - k_platform_q2_platform_q1 * l_platform_q3_platform_q1;
        let l_platform_q3_platform_q2 = inverse_platform_q2 * k_platform_q3_platform_q2;
        let minus_rhs_platform_q2 = S::from_f64(8.0) * w
            * (platform_q3 * w_22 + platform_q0 * w_23) + platform_q1 * w_24 * w_25
            + platform_q2 * self.k_3 * w_26 + rhs_platform_q0 * l_platform_q2_platform_q0
            + l_platform_q2_platform_q1 * rhs_platform_q1;
        let rhs_platform_q3 = S::from_f64(8.0) * w
            * (platform_q2 * w_22 - platform_q1 * w_23) + platform_q0 * w_24 * w_25
            - platform_q3 * self.k_3 * w_26 - rhs_platform_q0 * l_platform_q3_platform_q0
            - l_platform_q3_platform_q1 * rhs_platform_q1
            + l_platform_q3_platform_q2 * minus_rhs_platform_q2;
        let platform_norm_by_platform_q0 = platform_q0 * S::from_f64(2.0);
        let l_lambda_platform_norm_platform_q0 = platform_norm_by_platform_q0
            * inverse_platform_q0;
        let k_lambda_platform_norm_platform_q1 = platform_q1 * S::from_f64(2.0)
            - mass_platform_q1_platform_q0 * l_lambda_platform_norm_platform_q0;
        let l_lambda_platform_norm_platform_q1 = inverse_platform_q1
            * k_lambda_platform_norm_platform_q1;
        let k_lambda_platform_norm_platform_q2 = platform_q2 * S::from_f64(2.0)
            - mass_platform_q2_platform_q0 * l_lambda_platform_norm_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_platform_norm_platform_q1;
        let l_lambda_platform_norm_platform_q2 = inverse_platform_q2
            * k_lambda_platform_norm_platform_q2;
        let mass_platform_q3_platform_q3 = w_squared
            * (w_29 + platform_q0_squared * self.k_2) + platform_q3_squared * self.k_3;
        let pivot_platform_q3 = mass_platform_q3_platform_q3
            - mass_platform_q3_platform_q0 * l_platform_q3_platform_q0
            - k_platform_q3_platform_q1 * l_platform_q3_platform_q1
            - k_platform_q3_platform_q2 * l_platform_q3_platform_q2;
        let inverse_platform_q3 = S::from_f64(1.0) / pivot_platform_q3;
        let k_lambda_platform_norm_platform_q3 = platform_q3 * S::from_f64(2.0)
            - mass_platform_q3_platform_q0 * l_lambda_platform_norm_platform_q0
            - k_platform_q3_platform_q1 * l_lambda_platform_norm_platform_q1
            - k_platform_q3_platform_q2 * l_lambda_platform_norm_platform_q2;
        let l_lambda_platform_norm_platform_q3 = inverse_platform_q3
            * k_lambda_platform_norm_platform_q3;
        let rhs_lambda_platform_norm = l_lambda_platform_norm_platform_q2
            * minus_rhs_platform_q2 - S::from_f64(2.0) * w_26
            - rhs_platform_q0 * l_lambda_platform_norm_platform_q0
            - l_lambda_platform_norm_platform_q1 * rhs_platform_q1
            - l_lambda_platform_norm_platform_q3 * rhs_platform_q3;
        let w_35 = platform_q2_squared + platform_q3_squared;
        let w_36 = w * S::from_f64(2.0) * w_35 - S::from_f64(1.0);
        let w_37 = platform_q1 * platform_q2;
        let w_38 = platform_q0 * platform_q3;
        let w_39 = w_37 - w_38;
        let w_40 = w_39 * self.k_8;
        let w_41 = platform_x - self.k_6 - w_36 * self.k_7 + w * w_40;
        let w_42 = w_37 + w_38;
        let w_43 = w_42 * self.k_10;
        let w_44 = platform_q1_squared + platform_q3_squared;
        let w_45 = w * S::from_f64(2.0) * w_44 - S::from_f64(1.0);
        let w_46 = platform_y - self.k_9 + w * w_43 - w_45 * self.k_11;
        let w_47 = w_33 - w_32;
        let w_48 = w_28 + w_34;
        let w_49 = self.k_10 * w_47 + self.k_8 * w_48;
        let a1_on_platform_z = w * w_49 + platform_z;
        let w_50 = w_41 * w_41 + w_46 * w_46 + a1_on_platform_z * a1_on_platform_z;
        let sqrt_w_50 = w_50.sqrt();
        let w_51 = platform_q1 * self.k_11;
        let w_52 = w - w_squared * w_35;
        let w_53 = platform_q2 * w_52;
        let w_54 = platform_q2 * w_39;
        let w_55 = w * w_51 - self.k_10 * w_53 - w_squared * self.k_8 * w_54;
        let w_56 = w_squared * (self.k_8 * w_44 - w_43);
        let w_57 = platform_q1 * self.k_7;
        let w_58 = platform_q2 * w_56 + w * w_57;
        let w_59 = platform_q3 * self.k_11;
        let w_60 = platform_q0 * self.k_7;
        let w_61 = w_squared * w_49;
        let w_62 = w * (w_59 - w_60) - platform_q2 * w_61;
        let w_63 = w_41 * w_55 + w_46 * w_58 + a1_on_platform_z * w_62;
        let w_64 = w_squared * (w_35 * self.k_10 - w_40);
        let w_65 = platform_q0 * w_64 - w * w_59;
        let w_66 = platform_q3 * self.k_7;
        let w_67 = platform_q0 * w_56 + w * w_66;
        let w_68 = platform_q2 * self.k_7;
        let w_69 = platform_q0 * w_61 + w * (w_68 - w_51);
        let w_70 = w_41 * w_65 + w_46 * w_67 - a1_on_platform_z * w_69;
        let a1_leg_by_platform_q0 = S::from_f64(2.0) * sqrt_w_50 * w_70 / w_50;
        let l_lambda_a1_leg_platform_q0 = a1_leg_by_platform_q0 * inverse_platform_q0;
        let w_71 = platform_q2 * self.k_11;
        let w_72 = platform_q1 * w_64 + w * w_71;
        let w_73 = platform_q1 * w_42;
        let w_74 = w - w_squared * w_44;
        let w_75 = platform_q1 * w_74;
        let w_76 = w * w_68 - w_squared * self.k_10 * w_73 - self.k_8 * w_75;
        let w_77 = platform_q0 * self.k_11;
        let w_78 = w * (w_66 + w_77) - platform_q1 * w_61;
        let w_79 = w_41 * w_72 + w_46 * w_76 + a1_on_platform_z * w_78;
        let k_lambda_a1_leg_platform_q1 = S::from_f64(2.0) * sqrt_w_50 * w_79 / w_50
            - mass_platform_q1_platform_q0 * l_lambda_a1_leg_platform_q0;
        let l_lambda_a1_leg_platform_q1 = inverse_platform_q1
            * k_lambda_a1_leg_platform_q1;
        let k_lambda_a1_leg_platform_q2 = S::from_f64(2.0) * sqrt_w_50 * w_63 / w_50
            - mass_platform_q2_platform_q0 * l_lambda_a1_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_a1_leg_platform_q1;
        let l_lambda_a1_leg_platform_q2 = inverse_platform_q2
            * k_lambda_a1_leg_platform_q2;
        let w_80 = w_18 + w_19;
        let w_81 = w_squared * w_35 * w_20 - w * w_80;
        let w_82 = w_39 * w_20;
        let w_83 = w_7 + w_8 - w_9 - w_10;
        let w_84 = platform_x_dot + w_81 * self.k_48 - w_squared * self.k_49 * w_82
            - w * self.k_8 * w_83;
        let w_85 = w_7 + w_8 + w_9 + w_10;
        let w_86 = w_42 * w_20;
        let w_87 = w_17 + w_19;
        let w_88 = w_squared * w_44 * w_20 - w * w_87;
        let w_89 = platform_y_dot + w * self.k_10 * w_85 - w_squared * self.k_48 * w_86
            + self.k_49 * w_88;
        let w_90 = w_12 + w_13 + w_14 + w_15;
        let w_91 = w_2 + w_3 - w_4 - w_5;
        let w_92 = w * (self.k_8 * w_90 - self.k_10 * w_91)
            - w_squared * w_20 * (w_47 * self.k_48 + w_48 * self.k_49) + platform_z_dot;
        let w_93 = w_41 * w_84 + w_46 * w_89 + a1_on_platform_z * w_92;
        let w_94 = platform_q3 * w_52;
        let w_95 = platform_q3 * w_39;
        let w_96 = w * w_77 + self.k_10 * w_94 + w_squared * self.k_8 * w_95;
        let w_97 = platform_q3 * w_42;
        let w_98 = platform_q3 * w_74;
        let w_99 = w * w_60 - w_squared * self.k_10 * w_97 - self.k_8 * w_98;
        let w_100 = w * (w_71 + w_57) - platform_q3 * w_61;
        let w_101 = w_41 * w_96 - w_46 * w_99 - a1_on_platform_z * w_100;
        let w_50_squared = w_50 * w_50;
        let w_102 = w_93
            * ((w_101 * platform_q3_dot - w_70 * platform_q0_dot - w_79 * platform_q1_dot
                - w_63 * platform_q2_dot) / w_50_squared);
        let w_103 = platform_q3 * w_20;
        let w_104 = platform_q0 * w_83 - w_39 * platform_q0_dot + w_103;
        let w_105 = w_20 * w_24 * (w_39 * self.k_51 - w_35 * self.k_50);
        let w_106 = self.k_11 * platform_q3_dot;
        let w_107 = w_41
            * (w_squared
                * (self.k_8 * w_104 + w_35 * self.k_10 * platform_q0_dot
                    + platform_q0 * w_80 * self.k_48) + platform_q0 * w_105 - w * w_106);
        let w_108 = w_103 + w_42 * platform_q0_dot + platform_q0 * w_85;
        let w_109 = w_20 * w_24 * (w_42 * self.k_50 - w_44 * self.k_51);
        let w_110 = self.k_7 * platform_q3_dot;
        let w_111 = w_46
            * (w_squared
                * (self.k_8 * w_44 * platform_q0_dot - self.k_10 * w_108
                    + platform_q0 * self.k_49 * w_87) + platform_q0 * w_109 + w * w_110);
        let w_112 = platform_q2 * w_20;
        let w_113 = w_47 * platform_q0_dot - platform_q0 * w_91 - w_112;
        let w_114 = platform_q1 * w_20;
        let w_115 = w_114 + w_48 * platform_q0_dot + platform_q0 * w_90;
        let w_116 = w_20 * w_24 * (w_47 * self.k_50 + w_48 * self.k_51);
        let w_117 = self.k_7 * platform_q2_dot;
        let w_118 = self.k_11 * platform_q1_dot;
        let w_119 = w_65 * w_84 + w_107 + w_67 * w_89 + w_111 - w_69 * w_92
            - a1_on_platform_z
                * (w_squared * (self.k_10 * w_113 + self.k_8 * w_115)
                    - platform_q0 * w_116 + w * (w_117 - w_118));
        let w_120 = platform_q1 * w_83 - w_112 - w_39 * platform_q1_dot;
        let w_121 = self.k_11 * platform_q2_dot;
        let w_122 = w_41
            * (w_squared
                * (self.k_8 * w_120 + w_35 * self.k_10 * platform_q1_dot
                    + platform_q1 * w_80 * self.k_48) + platform_q1 * w_105 + w * w_121);
        let w_123 = w_squared * (w_112 + w_42 * platform_q1_dot + platform_q1 * w_85);
        let w_124 = platform_q1 * w_86;
        let w_125 = S::from_f64(4.0) * w_20;
        let w_126 = w_44 * w_24 * w_125 - S::from_f64(2.0) * w_squared * (w_20 + w_87);
        let w_127 = platform_q1 * w_126 + w_74 * platform_q1_dot;
        let w_128 = platform_q1 * w_91 - w_103 - w_47 * platform_q1_dot;
        let w_129 = platform_q0 * w_20;
        let w_130 = w_129 + w_48 * platform_q1_dot + platform_q1 * w_90;
        let w_131 = self.k_11 * platform_q0_dot;
        let w_132 = a1_on_platform_z
            * (w_squared * (self.k_10 * w_128 - self.k_8 * w_130) + w * (w_110 + w_131)
                + platform_q1 * w_116);
        let w_133 = w_72 * w_84 + w_122 + w_76 * w_89
            + w_46
                * (w * w_117 - self.k_10 * w_123 + w_24 * self.k_50 * w_124
                    - self.k_8 * w_127) + w_78 * w_92 + w_132;
        let w_134 = w_squared * (platform_q2 * w_83 - w_114 - w_39 * platform_q2_dot);
        let w_135 = w_35 * w_24 * w_125 - S::from_f64(2.0) * w_squared * (w_20 + w_80);
        let w_136 = platform_q2 * w_135 + w_52 * platform_q2_dot;
        let w_137 = platform_q2 * w_82;
        let w_138 = w_114 + w_42 * platform_q2_dot + platform_q2 * w_85;
        let w_139 = self.k_7 * platform_q1_dot;
        let w_140 = w_46
            * (w_squared
                * (self.k_8 * w_44 * platform_q2_dot - self.k_10 * w_138
                    + platform_q2 * self.k_49 * w_87) + platform_q2 * w_109 + w * w_139);
        let w_141 = platform_q2 * w_91 - w_47 * platform_q2_dot + w_129;
        let w_142 = w_103 + w_48 * platform_q2_dot + platform_q2 * w_90;
        let w_143 = self.k_7 * platform_q0_dot;
        let w_144 = a1_on_platform_z
            * (w_squared * (self.k_10 * w_141 - self.k_8 * w_142) + w * (w_106 - w_143)
                + platform_q2 * w_116);
        let w_145 = w_55 * w_84
            + w_41
                * (self.k_8 * w_134 + w * w_118 - self.k_10 * w_136
                    + w_24 * self.k_51 * w_137) + w_58 * w_89 + w_140 + w_62 * w_92
            + w_144;
        let w_146 = w_squared * (w_39 * platform_q3_dot - w_129 - platform_q3 * w_83);
        let w_147 = platform_q3 * w_135 + w_52 * platform_q3_dot;
        let w_148 = platform_q3 * w_82;
        let w_149 = w_squared * (w_129 + w_42 * platform_q3_dot + platform_q3 * w_85);
        let w_150 = platform_q3 * w_86;
        let w_151 = platform_q3 * w_126 + w_74 * platform_q3_dot;
        let w_152 = w_46
            * (w * w_143 - self.k_10 * w_149 + w_24 * self.k_50 * w_150
                - self.k_8 * w_151);
        let w_153 = platform_q3 * w_91 - w_114 - w_47 * platform_q3_dot;
        let w_154 = w_112 + w_48 * platform_q3_dot + platform_q3 * w_90;
        let w_155 = a1_on_platform_z
            * (w_squared * (self.k_10 * w_153 - self.k_8 * w_154) + w * (w_121 + w_139)
                + platform_q3 * w_116);
        let w_156 = w_96 * w_84
            + w_41
                * (self.k_8 * w_146 + w * w_131 + self.k_10 * w_147
                    - w_24 * self.k_51 * w_148) - w_99 * w_89 - w_152 - w_100 * w_92
            - w_155;
        let w_157 = S::from_f64(2.0)
            * (w_102
                + (platform_q0_dot * w_119 + platform_q1_dot * w_133
                    + platform_q2_dot * w_145 - platform_q3_dot * w_156) / w_50);
        let w_158 = w_157
            + (platform_x_dot * w_84 + platform_y_dot * w_89 + platform_z_dot * w_92)
                / w_50
            - w_93
                * ((w_41 * platform_x_dot + w_46 * platform_y_dot
                    + a1_on_platform_z * platform_z_dot) / w_50_squared);
        let w_159 = self.w * t;
        let w_160 = self.k_12 + w_159;
        let w_161 = self.k_25 + w_159;
        let w_162 = self.k_38 + w_159;
        let (
            [sin_w_159,
            sin_w_160,
            sin_w_161,
            sin_w_162,
            ],
            [cos_w_159,
            cos_w_160,
            cos_w_161,
            cos_w_162,
            ],
        ) = S::sin_cos_each([w_159, w_160, w_161, w_162]);
        let minus_k_lambda_a1_leg_platform_q3 = S::from_f64(2.0) * sqrt_w_50 * w_101
            / w_50 + mass_platform_q3_platform_q0 * l_lambda_a1_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_a1_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_a1_leg_platform_q2;
        let minus_l_lambda_a1_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_a1_leg_platform_q3;
        let a1_leg_by_platform_z = a1_on_platform_z * sqrt_w_50 / w_50;
        let l_lambda_a1_leg_platform_z = a1_leg_by_platform_z * self.inverse_platform_x;
        let minus_pivot_lambda_platform_norm = platform_norm_by_platform_q0
            * l_lambda_platform_norm_platform_q0
            + k_lambda_platform_norm_platform_q1 * l_lambda_platform_norm_platform_q1
            + k_lambda_platform_norm_platform_q2 * l_lambda_platform_norm_platform_q2
            + k_lambda_platform_norm_platform_q3 * l_lambda_platform_norm_platform_q3;
        let minus_inverse_lambda_platform_norm = S::from_f64(1.0)
            / minus_pivot_lambda_platform_norm;
        let k_lambda_a1_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_a1_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_a1_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_a1_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_a1_leg_platform_q2;
        let minus_l_lambda_a1_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_a1_leg_lambda_platform_norm;
        let rhs_lambda_a1_leg = l_lambda_a1_leg_platform_q2 * minus_rhs_platform_q2
            - (sqrt_w_50 * w_158 + sin_w_159 * self.k_54)
            - rhs_platform_q0 * l_lambda_a1_leg_platform_q0
            - l_lambda_a1_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_a1_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_a1_leg_platform_z
            + minus_l_lambda_a1_leg_lambda_platform_norm * rhs_lambda_platform_norm;
        let w_163 = w_39 * self.k_15;
        let w_164 = platform_x - self.k_13 - w_36 * self.k_14 + w * w_163;
        let w_165 = w_42 * self.k_17;
        let w_166 = platform_y - self.k_16 + w * w_165 - w_45 * self.k_18;
        let w_167 = w_47 * self.k_17 + w_48 * self.k_15;
        let a2_on_platform_z = w * w_167 + platform_z;
        let w_168 = w_164 * w_164 + w_166 * w_166 + a2_on_platform_z * a2_on_platform_z;
        let sqrt_w_168 = w_168.sqrt();
        let w_169 = platform_q1 * self.k_18;
        let w_170 = w * w_169 - w_53 * self.k_17 - w_squared * w_54 * self.k_15;
        let w_171 = w_squared * (w_44 * self.k_15 - w_165);
        let w_172 = platform_q1 * self.k_14;
        let w_173 = platform_q2 * w_171 + w * w_172;
        let w_174 = platform_q3 * self.k_18;
        let w_175 = platform_q0 * self.k_14;
        let w_176 = w_squared * w_167;
        let w_177 = w * (w_174 - w_175) - platform_q2 * w_176;
        let w_178 = w_164 * w_170 + w_166 * w_173 + a2_on_platform_z * w_177;
        let w_179 = w_squared * (w_35 * self.k_17 - w_163);
        let w_180 = platform_q0 * w_179 - w * w_174;
        let w_181 = platform_q3 * self.k_14;
        let w_182 = platform_q0 * w_171 + w * w_181;
        let w_183 = platform_q2 * self.k_14;
        let w_184 = platform_q0 * w_176 + w * (w_183 - w_169);
        let w_185 = w_164 * w_180 + w_166 * w_182 - a2_on_platform_z * w_184;
        let a2_leg_by_platform_q0 = S::from_f64(2.0) * sqrt_w_168 * w_185 / w_168;
        let l_lambda_a2_leg_platform_q0 = a2_leg_by_platform_q0 * inverse_platform_q0;
        let w_186 = platform_q2 * self.k_18;
        let w_187 = platform_q1 * w_179 + w * w_186;
        let w_188 = w * w_183 - w_squared * w_73 * self.k_17 - w_75 * self.k_15;
        let w_189 = platform_q0 * self.k_18;
        let w_190 = w * (w_181 + w_189) - platform_q1 * w_176;
        let w_191 = w_164 * w_187 + w_166 * w_188 + a2_on_platform_z * w_190;
        let k_lambda_a2_leg_platform_q1 = S::from_f64(2.0) * sqrt_w_168 * w_191 / w_168
            - mass_platform_q1_platform_q0 * l_lambda_a2_leg_platform_q0;
        let l_lambda_a2_leg_platform_q1 = inverse_platform_q1
            * k_lambda_a2_leg_platform_q1;
        let k_lambda_a2_leg_platform_q2 = S::from_f64(2.0) * sqrt_w_168 * w_178 / w_168
            - mass_platform_q2_platform_q0 * l_lambda_a2_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_a2_leg_platform_q1;
        let l_lambda_a2_leg_platform_q2 = inverse_platform_q2
            * k_lambda_a2_leg_platform_q2;
        let w_192 = platform_x_dot + w_81 * self.k_55 - w_squared * w_82 * self.k_56
            - w * self.k_15 * w_83;
        let w_193 = platform_y_dot + w * self.k_17 * w_85 - w_squared * w_86 * self.k_55
            + w_88 * self.k_56;
        let w_194 = w * (self.k_15 * w_90 - self.k_17 * w_91)
            - w_squared * w_20 * (w_47 * self.k_55 + w_48 * self.k_56) + platform_z_dot;
        let w_195 = w_164 * w_192 + w_166 * w_193 + a2_on_platform_z * w_194;
        let w_196 = w * w_189 + w_94 * self.k_17 + w_squared * w_95 * self.k_15;
        let w_197 = w * w_175 - w_squared * w_97 * self.k_17 - w_98 * self.k_15;
        let w_198 = w * (w_186 + w_172) - platform_q3 * w_176;
        let w_199 = w_164 * w_196 - w_166 * w_197 - a2_on_platform_z * w_198;
        let w_168_squared = w_168 * w_168;
        let w_200 = w_195
            * ((w_199 * platform_q3_dot - w_185 * platform_q0_dot
                - w_191 * platform_q1_dot - w_178 * platform_q2_dot) / w_168_squared);
        let w_201 = w_20 * w_24 * (w_39 * self.k_58 - w_35 * self.k_57);
        let w_202 = self.k_18 * platform_q3_dot;
        let w_203 = w_164
            * (w_squared
                * (self.k_15 * w_104 + w_35 * self.k_17 * platform_q0_dot
                    + platform_q0 * w_80 * self.k_55) + platform_q0 * w_201 - w * w_202);
        let w_204 = w_20 * w_24 * (w_42 * self.k_57 - w_44 * self.k_58);
        let w_205 = self.k_14 * platform_q3_dot;
        let w_206 = w_166
            * (w_squared
                * (w_44 * self.k_15 * platform_q0_dot - self.k_17 * w_108
                    + platform_q0 * w_87 * self.k_56) + platform_q0 * w_204 + w * w_205);
        let w_207 = w_20 * w_24 * (w_47 * self.k_57 + w_48 * self.k_58);
        let w_208 = self.k_14 * platform_q2_dot;
        let w_209 = self.k_18 * platform_q1_dot;
        let w_210 = w_180 * w_192 + w_203 + w_182 * w_193 + w_206 - w_184 * w_194
            - a2_on_platform_z
                * (w_squared * (self.k_17 * w_113 + self.k_15 * w_115)
                    - platform_q0 * w_207 + w * (w_208 - w_209));
        let w_211 = self.k_18 * platform_q2_dot;
        let w_212 = w_164
            * (w_squared
                * (self.k_15 * w_120 + w_35 * self.k_17 * platform_q1_dot
                    + platform_q1 * w_80 * self.k_55) + platform_q1 * w_201 + w * w_211);
        let w_213 = self.k_18 * platform_q0_dot;
        let w_214 = a2_on_platform_z
            * (w_squared * (self.k_17 * w_128 - self.k_15 * w_130) + w * (w_205 + w_213)
                + platform_q1 * w_207);
        let w_215 = w_187 * w_192 + w_212 + w_188 * w_193
            + w_166
                * (w * w_208 - self.k_17 * w_123 + w_24 * w_124 * self.k_57
                    - self.k_15 * w_127) + w_190 * w_194 + w_214;
        let w_216 = self.k_14 * platform_q1_dot;
        let w_217 = w_166
            * (w_squared
                * (w_44 * self.k_15 * platform_q2_dot - self.k_17 * w_138
                    + platform_q2 * w_87 * self.k_56) + platform_q2 * w_204 + w * w_216);
        let w_218 = self.k_14 * platform_q0_dot;
        let w_219 = a2_on_platform_z
            * (w_squared * (self.k_17 * w_141 - self.k_15 * w_142) + w * (w_202 - w_218)
                + platform_q2 * w_207);
        let w_220 = w_170 * w_192
            + w_164
                * (self.k_15 * w_134 + w * w_209 - self.k_17 * w_136
                    + w_24 * w_137 * self.k_58) + w_173 * w_193 + w_217 + w_177 * w_194
            + w_219;
        let w_221 = w_166
            * (w * w_218 - self.k_17 * w_149 + w_24 * w_150 * self.k_57
                - self.k_15 * w_151);
        let w_222 = a2_on_platform_z
            * (w_squared * (self.k_17 * w_153 - self.k_15 * w_154) + w * (w_211 + w_216)
                + platform_q3 * w_207);
        let w_223 = w_196 * w_192
            + w_164
                * (self.k_15 * w_146 + w * w_213 + self.k_17 * w_147
                    - w_24 * w_148 * self.k_58) - w_197 * w_193 - w_221 - w_198 * w_194
            - w_222;
        let w_224 = S::from_f64(2.0)
            * (w_200
                + (platform_q0_dot * w_210 + platform_q1_dot * w_215
                    + platform_q2_dot * w_220 - platform_q3_dot * w_223) / w_168);
        let w_225 = w_224
            + (platform_x_dot * w_192 + platform_y_dot * w_193 + platform_z_dot * w_194)
                / w_168
            - w_195
                * ((w_164 * platform_x_dot + w_166 * platform_y_dot
                    + a2_on_platform_z * platform_z_dot) / w_168_squared);
        let w_226 = sin_w_159 * self.k_52;
        let w_227 = self.k_53 * sin_w_160;
        let minus_k_lambda_a2_leg_platform_q3 = S::from_f64(2.0) * sqrt_w_168 * w_199
            / w_168 + mass_platform_q3_platform_q0 * l_lambda_a2_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_a2_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_a2_leg_platform_q2;
        let minus_l_lambda_a2_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_a2_leg_platform_q3;
        let a2_leg_by_platform_z = a2_on_platform_z * sqrt_w_168 / w_168;
        let l_lambda_a2_leg_platform_z = a2_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_a2_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_a2_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_a2_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_a2_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_a2_leg_platform_q2;
        let minus_l_lambda_a2_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_a2_leg_lambda_platform_norm;
        let a1_leg_by_platform_x = w_41 * sqrt_w_50 / w_50;
        let l_lambda_a1_leg_platform_x = a1_leg_by_platform_x * self.inverse_platform_x;
        let a1_leg_by_platform_y = w_46 * sqrt_w_50 / w_50;
        let l_lambda_a1_leg_platform_y = a1_leg_by_platform_y * self.inverse_platform_x;
        let w_228 = a1_leg_by_platform_q0 * l_lambda_a1_leg_platform_q0
            + k_lambda_a1_leg_platform_q1 * l_lambda_a1_leg_platform_q1
            + k_lambda_a1_leg_platform_q2 * l_lambda_a1_leg_platform_q2
            + minus_k_lambda_a1_leg_platform_q3 * minus_l_lambda_a1_leg_platform_q3
            + a1_leg_by_platform_x * l_lambda_a1_leg_platform_x
            + a1_leg_by_platform_y * l_lambda_a1_leg_platform_y
            + a1_leg_by_platform_z * l_lambda_a1_leg_platform_z;
        let pivot_lambda_a1_leg = k_lambda_a1_leg_lambda_platform_norm
            * minus_l_lambda_a1_leg_lambda_platform_norm - w_228;
        let inverse_lambda_a1_leg = S::from_f64(1.0) / pivot_lambda_a1_leg;
        let a2_leg_by_platform_x = w_164 * sqrt_w_168 / w_168;
        let l_lambda_a2_leg_platform_x = a2_leg_by_platform_x * self.inverse_platform_x;
        let a2_leg_by_platform_y = w_166 * sqrt_w_168 / w_168;
        let l_lambda_a2_leg_platform_y = a2_leg_by_platform_y * self.inverse_platform_x;
        let k_lambda_a2_leg_lambda_a1_leg = k_lambda_a1_leg_lambda_platform_norm
            * minus_l_lambda_a2_leg_lambda_platform_norm
            - a1_leg_by_platform_q0 * l_lambda_a2_leg_platform_q0
            - k_lambda_a1_leg_platform_q1 * l_lambda_a2_leg_platform_q1
            - k_lambda_a1_leg_platform_q2 * l_lambda_a2_leg_platform_q2
            - minus_k_lambda_a1_leg_platform_q3 * minus_l_lambda_a2_leg_platform_q3
            - a1_leg_by_platform_x * l_lambda_a2_leg_platform_x
            - a1_leg_by_platform_y * l_lambda_a2_leg_platform_y
            - a1_leg_by_platform_z * l_lambda_a2_leg_platform_z;
        let l_lambda_a2_leg_lambda_a1_leg = inverse_lambda_a1_leg
            * k_lambda_a2_leg_lambda_a1_leg;
        let rhs_lambda_a2_leg = l_lambda_a2_leg_platform_q2 * minus_rhs_platform_q2
            - (sqrt_w_168 * w_225 + w_226 - w_227)
            - rhs_platform_q0 * l_lambda_a2_leg_platform_q0
            - l_lambda_a2_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_a2_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_a2_leg_platform_z
            + minus_l_lambda_a2_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_a2_leg_lambda_a1_leg * rhs_lambda_a1_leg;
        let w_229 = w_39 * self.k_21;
        let w_230 = platform_x - self.k_19 - w_36 * self.k_20 + w * w_229;
        let w_231 = w_42 * self.k_23;
        let w_232 = platform_y - self.k_22 + w * w_231 - w_45 * self.k_24;
        let w_233 = w_47 * self.k_23 + w_48 * self.k_21;
        let b1_on_platform_z = w * w_233 + platform_z;
        let w_234 = w_230 * w_230 + w_232 * w_232 + b1_on_platform_z * b1_on_platform_z;
        let sqrt_w_234 = w_234.sqrt();
        let w_235 = platform_q1 * self.k_24;
        let w_236 = w * w_235 - w_53 * self.k_23 - w_squared * w_54 * self.k_21;
        let w_237 = w_squared * (w_44 * self.k_21 - w_231);
        let w_238 = platform_q1 * self.k_20;
        let w_239 = platform_q2 * w_237 + w * w_238;
        let w_240 = platform_q3 * self.k_24;
        let w_241 = platform_q0 * self.k_20;
        let w_242 = w_squared * w_233;
        let w_243 = w * (w_240 - w_241) - platform_q2 * w_242;
        let w_244 = w_230 * w_236 + w_232 * w_239 + b1_on_platform_z * w_243;
        let w_245 = w_squared * (w_35 * self.k_23 - w_229);
        let w_246 = platform_q0 * w_245 - w * w_240;
        let w_247 = platform_q3 * self.k_20;
        let w_248 = platform_q0 * w_237 + w * w_247;
        let w_249 = platform_q2 * self.k_20;
        let w_250 = platform_q0 * w_242 + w * (w_249 - w_235);
        let w_251 = w_230 * w_246 + w_232 * w_248 - b1_on_platform_z * w_250;
        let b1_leg_by_platform_q0 = S::from_f64(2.0) * sqrt_w_234 * w_251 / w_234;
        let l_lambda_b1_leg_platform_q0 = b1_leg_by_platform_q0 * inverse_platform_q0;
        let w_252 = platform_q2 * self.k_24;
        let w_253 = platform_q1 * w_245 + w * w_252;
        let w_254 = w * w_249 - w_squared * w_73 * self.k_23 - w_75 * self.k_21;
        let w_255 = platform_q0 * self.k_24;
        let w_256 = w * (w_247 + w_255) - platform_q1 * w_242;
        let w_257 = w_230 * w_253 + w_232 * w_254 + b1_on_platform_z * w_256;
        let k_lambda_b1_leg_platform_q1 = S::from_f64(2.0) * sqrt_w_234 * w_257 / w_234
            - mass_platform_q1_platform_q0 * l_lambda_b1_leg_platform_q0;
        let l_lambda_b1_leg_platform_q1 = inverse_platform_q1
            * k_lambda_b1_leg_platform_q1;
        let k_lambda_b1_leg_platform_q2 = S::from_f64(2.0) * sqrt_w_234 * w_244 / w_234
            - mass_platform_q2_platform_q0 * l_lambda_b1_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_b1_leg_platform_q1;
        let l_lambda_b1_leg_platform_q2 = inverse_platform_q2
            * k_lambda_b1_leg_platform_q2;
        let w_258 = platform_x_dot + w_81 * self.k_59 - w_squared * w_82 * self.k_60
            - w * self.k_21 * w_83;
        let w_259 = platform_y_dot + w * self.k_23 * w_85 - w_squared * w_86 * self.k_59
            + w_88 * self.k_60;
        let w_260 = w * (self.k_21 * w_90 - self.k_23 * w_91)
            - w_squared * w_20 * (w_47 * self.k_59 + w_48 * self.k_60) + platform_z_dot;
        let w_261 = w_230 * w_258 + w_232 * w_259 + b1_on_platform_z * w_260;
        let w_262 = w * w_255 + w_94 * self.k_23 + w_squared * w_95 * self.k_21;
        let w_263 = w * w_241 - w_squared * w_97 * self.k_23 - w_98 * self.k_21;
        let w_264 = w * (w_252 + w_238) - platform_q3 * w_242;
        let w_265 = w_230 * w_262 - w_232 * w_263 - b1_on_platform_z * w_264;
        let w_234_squared = w_234 * w_234;
        let w_266 = w_261
            * ((w_265 * platform_q3_dot - w_251 * platform_q0_dot
                - w_257 * platform_q1_dot - w_244 * platform_q2_dot) / w_234_squared);
        let w_267 = w_20 * w_24 * (w_39 * self.k_62 - w_35 * self.k_61);
        let w_268 = self.k_24 * platform_q3_dot;
        let w_269 = w_230
            * (w_squared
                * (self.k_21 * w_104 + w_35 * self.k_23 * platform_q0_dot
                    + platform_q0 * w_80 * self.k_59) + platform_q0 * w_267 - w * w_268);
        let w_270 = w_20 * w_24 * (w_42 * self.k_61 - w_44 * self.k_62);
        let w_271 = self.k_20 * platform_q3_dot;
        let w_272 = w_232
            * (w_squared
                * (w_44 * self.k_21 * platform_q0_dot - self.k_23 * w_108
                    + platform_q0 * w_87 * self.k_60) + platform_q0 * w_270 + w * w_271);
        let w_273 = w_20 * w_24 * (w_47 * self.k_61 + w_48 * self.k_62);
        let w_274 = self.k_20 * platform_q2_dot;
        let w_275 = self.k_24 * platform_q1_dot;
        let w_276 = w_246 * w_258 + w_269 + w_248 * w_259 + w_272 - w_250 * w_260
            - b1_on_platform_z
                * (w_squared * (self.k_23 * w_113 + self.k_21 * w_115)
                    - platform_q0 * w_273 + w * (w_274 - w_275));
        let w_277 = self.k_24 * platform_q2_dot;
        let w_278 = w_230
            * (w_squared
                * (self.k_21 * w_120 + w_35 * self.k_23 * platform_q1_dot
                    + platform_q1 * w_80 * self.k_59) + platform_q1 * w_267 + w * w_277);
        let w_279 = self.k_24 * platform_q0_dot;
        let w_280 = b1_on_platform_z
            * (w_squared * (self.k_23 * w_128 - self.k_21 * w_130) + w * (w_271 + w_279)
                + platform_q1 * w_273);
        let w_281 = w_253 * w_258 + w_278 + w_254 * w_259
            + w_232
                * (w * w_274 - self.k_23 * w_123 + w_24 * w_124 * self.k_61
                    - self.k_21 * w_127) + w_256 * w_260 + w_280;
        let w_282 = self.k_20 * platform_q1_dot;
        let w_283 = w_232
            * (w_squared
                * (w_44 * self.k_21 * platform_q2_dot - self.k_23 * w_138
                    + platform_q2 * w_87 * self.k_60) + platform_q2 * w_270 + w * w_282);
        let w_284 = self.k_20 * platform_q0_dot;
        let w_285 = b1_on_platform_z
            * (w_squared * (self.k_23 * w_141 - self.k_21 * w_142) + w * (w_268 - w_284)
                + platform_q2 * w_273);
        let w_286 = w_236 * w_258
            + w_230
                * (self.k_21 * w_134 + w * w_275 - self.k_23 * w_136
                    + w_24 * w_137 * self.k_62) + w_239 * w_259 + w_283 + w_243 * w_260
            + w_285;
        let w_287 = w_232
            * (w * w_284 - self.k_23 * w_149 + w_24 * w_150 * self.k_61
                - self.k_21 * w_151);
        let w_288 = b1_on_platform_z
            * (w_squared * (self.k_23 * w_153 - self.k_21 * w_154) + w * (w_277 + w_282)
                + platform_q3 * w_273);
        let w_289 = w_262 * w_258
            + w_230
                * (self.k_21 * w_146 + w * w_279 + self.k_23 * w_147
                    - w_24 * w_148 * self.k_62) - w_263 * w_259 - w_287 - w_264 * w_260
            - w_288;
        let w_290 = S::from_f64(2.0)
            * (w_266
                + (platform_q0_dot * w_276 + platform_q1_dot * w_281
                    + platform_q2_dot * w_286 - platform_q3_dot * w_289) / w_234);
        let w_291 = w_290
            + (platform_x_dot * w_258 + platform_y_dot * w_259 + platform_z_dot * w_260)
                / w_234
            - w_261
                * ((w_230 * platform_x_dot + w_232 * platform_y_dot
                    + b1_on_platform_z * platform_z_dot) / w_234_squared);
        let minus_k_lambda_b1_leg_platform_q3 = S::from_f64(2.0) * sqrt_w_234 * w_265
            / w_234 + mass_platform_q3_platform_q0 * l_lambda_b1_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_b1_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_b1_leg_platform_q2;
        let minus_l_lambda_b1_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_b1_leg_platform_q3;
        let b1_leg_by_platform_z = b1_on_platform_z * sqrt_w_234 / w_234;
        let l_lambda_b1_leg_platform_z = b1_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_b1_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_b1_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_b1_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_b1_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_b1_leg_platform_q2;
        let minus_l_lambda_b1_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_b1_leg_lambda_platform_norm;
        let b1_leg_by_platform_x = w_230 * sqrt_w_234 / w_234;
        let l_lambda_b1_leg_platform_x = b1_leg_by_platform_x * self.inverse_platform_x;
        let b1_leg_by_platform_y = w_232 * sqrt_w_234 / w_234;
        let l_lambda_b1_leg_platform_y = b1_leg_by_platform_y * self.inverse_platform_x;
        let k_lambda_b1_leg_lambda_a1_leg = k_lambda_a1_leg_lambda_platform_norm
            * minus_l_lambda_b1_leg_lambda_platform_norm
            - a1_leg_by_platform_q0 * l_lambda_b1_leg_platform_q0
            - k_lambda_a1_leg_platform_q1 * l_lambda_b1_leg_platform_q1
            - k_lambda_a1_leg_platform_q2 * l_lambda_b1_leg_platform_q2
            - minus_k_lambda_a1_leg_platform_q3 * minus_l_lambda_b1_leg_platform_q3
            - a1_leg_by_platform_x * l_lambda_b1_leg_platform_x
            - a1_leg_by_platform_y * l_lambda_b1_leg_platform_y
            - a1_leg_by_platform_z * l_lambda_b1_leg_platform_z;
        let l_lambda_b1_leg_lambda_a1_leg = inverse_lambda_a1_leg
            * k_lambda_b1_leg_lambda_a1_leg;
        let w_292 = a2_leg_by_platform_q0 * l_lambda_a2_leg_platform_q0
            + k_lambda_a2_leg_platform_q1 * l_lambda_a2_leg_platform_q1
            + k_lambda_a2_leg_platform_q2 * l_lambda_a2_leg_platform_q2
            + minus_k_lambda_a2_leg_platform_q3 * minus_l_lambda_a2_leg_platform_q3
            + a2_leg_by_platform_x * l_lambda_a2_leg_platform_x
            + a2_leg_by_platform_y * l_lambda_a2_leg_platform_y
            + a2_leg_by_platform_z * l_lambda_a2_leg_platform_z;
        let pivot_lambda_a2_leg = k_lambda_a2_leg_lambda_platform_norm
            * minus_l_lambda_a2_leg_lambda_platform_norm - w_292
            - k_lambda_a2_leg_lambda_a1_leg * l_lambda_a2_leg_lambda_a1_leg;
        let inverse_lambda_a2_leg = S::from_f64(1.0) / pivot_lambda_a2_leg;
        let k_lambda_b1_leg_lambda_a2_leg = k_lambda_a2_leg_lambda_platform_norm
            * minus_l_lambda_b1_leg_lambda_platform_norm
            - a2_leg_by_platform_q0 * l_lambda_b1_leg_platform_q0
            - k_lambda_a2_leg_platform_q1 * l_lambda_b1_leg_platform_q1
            - k_lambda_a2_leg_platform_q2 * l_lambda_b1_leg_platform_q2
            - minus_k_lambda_a2_leg_platform_q3 * minus_l_lambda_b1_leg_platform_q3
            - a2_leg_by_platform_x * l_lambda_b1_leg_platform_x
            - a2_leg_by_platform_y * l_lambda_b1_leg_platform_y
            - a2_leg_by_platform_z * l_lambda_b1_leg_platform_z
            - k_lambda_a2_leg_lambda_a1_leg * l_lambda_b1_leg_lambda_a1_leg;
        let l_lambda_b1_leg_lambda_a2_leg = inverse_lambda_a2_leg
            * k_lambda_b1_leg_lambda_a2_leg;
        let rhs_lambda_b1_leg = l_lambda_b1_leg_platform_q2 * minus_rhs_platform_q2
            - (sqrt_w_234 * w_291 + w_226 + w_227)
            - rhs_platform_q0 * l_lambda_b1_leg_platform_q0
            - l_lambda_b1_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_b1_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_b1_leg_platform_z
            + minus_l_lambda_b1_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_b1_leg_lambda_a1_leg * rhs_lambda_a1_leg
            - l_lambda_b1_leg_lambda_a2_leg * rhs_lambda_a2_leg;
        let w_293 = w_39 * self.k_28;
        let w_294 = platform_x - self.k_26 - w_36 * self.k_27 + w * w_293;
        let w_295 = w_42 * self.k_30;
        let w_296 = platform_y - self.k_29 + w * w_295 - w_45 * self.k_31;
        let w_297 = w_47 * self.k_30 + w_48 * self.k_28;
        let b2_on_platform_z = w * w_297 + platform_z;
        let w_298 = w_294 * w_294 + w_296 * w_296 + b2_on_platform_z * b2_on_platform_z;
        let sqrt_w_298 = w_298.sqrt();
        let w_299 = platform_q1 * self.k_31;
        let w_300 = w * w_299 - w_53 * self.k_30 - w_squared * w_54 * self.k_28;
        let w_301 = w_squared * (w_44 * self.k_28 - w_295);
        let w_302 = platform_q1 * self.k_27;
        let w_303 = platform_q2 * w_301 + w * w_302;
        let w_304 = platform_q3 * self.k_31;
        let w_305 = platform_q0 * self.k_27;
        let w_306 = w_squared * w_297;
        let w_307 = w * (w_304 - w_305) - platform_q2 * w_306;
        let w_308 = w_294 * w_300 + w_296 * w_303 + b2_on_platform_z * w_307;
        let w_309 = w_squared * (w_35 * self.k_30 - w_293);
        let w_310 = platform_q0 * w_309 - w * w_304;
        let w_311 = platform_q3 * self.k_27;
        let w_312 = platform_q0 * w_301 + w * w_311;
        let w_313 = platform_q2 * self.k_27;
        let w_314 = platform_q0 * w_306 + w * (w_313 - w_299);
        let w_315 = w_294 * w_310 + w_296 * w_312 - b2_on_platform_z * w_314;
        let b2_leg_by_platform_q0 = S::from_f64(2.0) * sqrt_w_298 * w_315 / w_298;
        let l_lambda_b2_leg_platform_q0 = b2_leg_by_platform_q0 * inverse_platform_q0;
        let w_316 = platform_q2 * self.k_31;
        let w_317 = platform_q1 * w_309 + w * w_316;
        let w_318 = w * w_313 - w_squared * w_73 * self.k_30 - w_75 * self.k_28;
        let w_319 = platform_q0 * self.k_31;
        let w_320 = w * (w_311 + w_319) - platform_q1 * w_306;
        let w_321 = w_294 * w_317 + w_296 * w_318 + b2_on_platform_z * w_320;
        let k_lambda_b2_leg_platform_q1 = S::from_f64(2.0) * sqrt_w_298 * w_321 / w_298
            - mass_platform_q1_platform_q0 * l_lambda_b2_leg_platform_q0;
        let l_lambda_b2_leg_platform_q1 = inverse_platform_q1
            * k_lambda_b2_leg_platform_q1;
        let k_lambda_b2_leg_platform_q2 = S::from_f64(2.0) * sqrt_w_298 * w_308 / w_298
            - mass_platform_q2_platform_q0 * l_lambda_b2_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_b2_leg_platform_q1;
        let l_lambda_b2_leg_platform_q2 = inverse_platform_q2
            * k_lambda_b2_leg_platform_q2;
        let w_322 = platform_x_dot + w_81 * self.k_63 - w_squared * w_82 * self.k_64
            - w * self.k_28 * w_83;
        let w_323 = platform_y_dot + w * self.k_30 * w_85 - w_squared * w_86 * self.k_63
            + w_88 * self.k_64;
        let w_324 = w * (self.k_28 * w_90 - self.k_30 * w_91)
            - w_squared * w_20 * (w_47 * self.k_63 + w_48 * self.k_64) + platform_z_dot;
        let w_325 = w_294 * w_322 + w_296 * w_323 + b2_on_platform_z * w_324;
        let w_326 = w * w_319 + w_94 * self.k_30 + w_squared * w_95 * self.k_28;
        let w_327 = w * w_305 - w_squared * w_97 * self.k_30 - w_98 * self.k_28;
        let w_328 = w * (w_316 + w_302) - platform_q3 * w_306;
        let w_329 = w_294 * w_326 - w_296 * w_327 - b2_on_platform_z * w_328;
        let w_298_squared = w_298 * w_298;
        let w_330 = w_325
            * ((w_329 * platform_q3_dot - w_315 * platform_q0_dot
                - w_321 * platform_q1_dot - w_308 * platform_q2_dot) / w_298_squared);
        let w_331 = w_20 * w_24 * (w_39 * self.k_66 - w_35 * self.k_65);
        let w_332 = self.k_31 * platform_q3_dot;
        let w_333 = w_294
            * (w_squared
                * (self.k_28 * w_104 + w_35 * self.k_30 * platform_q0_dot
                    + platform_q0 * w_80 * self.k_63) + platform_q0 * w_331 - w * w_332);
        let w_334 = w_20 * w_24 * (w_42 * self.k_65 - w_44 * self.k_66);
        let w_335 = self.k_27 * platform_q3_dot;
        let w_336 = w_296
            * (w_squared
                * (w_44 * self.k_28 * platform_q0_dot - self.k_30 * w_108
                    + platform_q0 * w_87 * self.k_64) + platform_q0 * w_334 + w * w_335);
        let w_337 = w_20 * w_24 * (w_47 * self.k_65 + w_48 * self.k_66);
        let w_338 = self.k_27 * platform_q2_dot;
        let w_339 = self.k_31 * platform_q1_dot;
        let w_340 = w_310 * w_322 + w_333 + w_312 * w_323 + w_336 - w_314 * w_324
            - b2_on_platform_z
                * (w_squared * (self.k_30 * w_113 + self.k_28 * w_115)
                    - platform_q0 * w_337 + w * (w_338 - w_339));
        let w_341 = self.k_31 * platform_q2_dot;
        let w_342 = w_294
            * (w_squared
                * (self.k_28 * w_120 + w_35 * self.k_30 * platform_q1_dot
                    + platform_q1 * w_80 * self.k_63) + platform_q1 * w_331 + w * w_341);
        let w_343 = self.k_31 * platform_q0_dot;
        let w_344 = b2_on_platform_z
            * (w_squared * (self.k_30 * w_128 - self.k_28 * w_130) + w * (w_335 + w_343)
                + platform_q1 * w_337);
        let w_345 = w_317 * w_322 + w_342 + w_318 * w_323
            + w_296
                * (w * w_338 - self.k_30 * w_123 + w_24 * w_124 * self.k_65
                    - self.k_28 * w_127) + w_320 * w_324 + w_344;
        let w_346 = self.k_27 * platform_q1_dot;
        let w_347 = w_296
            * (w_squared
                * (w_44 * self.k_28 * platform_q2_dot - self.k_30 * w_138
                    + platform_q2 * w_87 * self.k_64) + platform_q2 * w_334 + w * w_346);
        let w_348 = self.k_27 * platform_q0_dot;
        let w_349 = b2_on_platform_z
            * (w_squared * (self.k_30 * w_141 - self.k_28 * w_142) + w * (w_332 - w_348)
                + platform_q2 * w_337);
        let w_350 = w_300 * w_322
            + w_294
                * (self.k_28 * w_134 + w * w_339 - self.k_30 * w_136
                    + w_24 * w_137 * self.k_66) + w_303 * w_323 + w_347 + w_307 * w_324
            + w_349;
        let w_351 = w_296
            * (w * w_348 - self.k_30 * w_149 + w_24 * w_150 * self.k_65
                - self.k_28 * w_151);
        let w_352 = b2_on_platform_z
            * (w_squared * (self.k_30 * w_153 - self.k_28 * w_154) + w * (w_341 + w_346)
                + platform_q3 * w_337);
        let w_353 = w_326 * w_322
            + w_294
                * (self.k_28 * w_146 + w * w_343 + self.k_30 * w_147
                    - w_24 * w_148 * self.k_66) - w_327 * w_323 - w_351 - w_328 * w_324
            - w_352;
        let w_354 = S::from_f64(2.0)
            * (w_330
                + (platform_q0_dot * w_340 + platform_q1_dot * w_345
                    + platform_q2_dot * w_350 - platform_q3_dot * w_353) / w_298);
        let w_355 = w_354
            + (platform_x_dot * w_322 + platform_y_dot * w_323 + platform_z_dot * w_324)
                / w_298
            - w_325
                * ((w_294 * platform_x_dot + w_296 * platform_y_dot
                    + b2_on_platform_z * platform_z_dot) / w_298_squared);
        let w_356 = self.k_53 * sin_w_161;
        let minus_k_lambda_b2_leg_platform_q3 = S::from_f64(2.0) * sqrt_w_298 * w_329
            / w_298 + mass_platform_q3_platform_q0 * l_lambda_b2_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_b2_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_b2_leg_platform_q2;
        let minus_l_lambda_b2_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_b2_leg_platform_q3;
        let b2_leg_by_platform_z = b2_on_platform_z * sqrt_w_298 / w_298;
        let l_lambda_b2_leg_platform_z = b2_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_b2_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_b2_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_b2_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_b2_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_b2_leg_platform_q2;
        let minus_l_lambda_b2_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_b2_leg_lambda_platform_norm;
        let b2_leg_by_platform_x = w_294 * sqrt_w_298 / w_298;
        let l_lambda_b2_leg_platform_x = b2_leg_by_platform_x * self.inverse_platform_x;
        let b2_leg_by_platform_y = w_296 * sqrt_w_298 / w_298;
        let l_lambda_b2_leg_platform_y = b2_leg_by_platform_y * self.inverse_platform_x;
        let k_lambda_b2_leg_lambda_a1_leg = k_lambda_a1_leg_lambda_platform_norm
            * minus_l_lambda_b2_leg_lambda_platform_norm
            - a1_leg_by_platform_q0 * l_lambda_b2_leg_platform_q0
            - k_lambda_a1_leg_platform_q1 * l_lambda_b2_leg_platform_q1
            - k_lambda_a1_leg_platform_q2 * l_lambda_b2_leg_platform_q2
            - minus_k_lambda_a1_leg_platform_q3 * minus_l_lambda_b2_leg_platform_q3
            - a1_leg_by_platform_x * l_lambda_b2_leg_platform_x
            - a1_leg_by_platform_y * l_lambda_b2_leg_platform_y
            - a1_leg_by_platform_z * l_lambda_b2_leg_platform_z;
        let l_lambda_b2_leg_lambda_a1_leg = inverse_lambda_a1_leg
            * k_lambda_b2_leg_lambda_a1_leg;
        let k_lambda_b2_leg_lambda_a2_leg = k_lambda_a2_leg_lambda_platform_norm
            * minus_l_lambda_b2_leg_lambda_platform_norm
            - a2_leg_by_platform_q0 * l_lambda_b2_leg_platform_q0
            - k_lambda_a2_leg_platform_q1 * l_lambda_b2_leg_platform_q1
            - k_lambda_a2_leg_platform_q2 * l_lambda_b2_leg_platform_q2
            - minus_k_lambda_a2_leg_platform_q3 * minus_l_lambda_b2_leg_platform_q3
            - a2_leg_by_platform_x * l_lambda_b2_leg_platform_x
            - a2_leg_by_platform_y * l_lambda_b2_leg_platform_y
            - a2_leg_by_platform_z * l_lambda_b2_leg_platform_z
            - k_lambda_a2_leg_lambda_a1_leg * l_lambda_b2_leg_lambda_a1_leg;
        let l_lambda_b2_leg_lambda_a2_leg = inverse_lambda_a2_leg
            * k_lambda_b2_leg_lambda_a2_leg;
        let w_357 = b1_leg_by_platform_q0 * l_lambda_b1_leg_platform_q0
            + k_lambda_b1_leg_platform_q1 * l_lambda_b1_leg_platform_q1
            + k_lambda_b1_leg_platform_q2 * l_lambda_b1_leg_platform_q2
            + minus_k_lambda_b1_leg_platform_q3 * minus_l_lambda_b1_leg_platform_q3
            + b1_leg_by_platform_x * l_lambda_b1_leg_platform_x
            + b1_leg_by_platform_y * l_lambda_b1_leg_platform_y
            + b1_leg_by_platform_z * l_lambda_b1_leg_platform_z;
        let pivot_lambda_b1_leg = k_lambda_b1_leg_lambda_platform_norm
            * minus_l_lambda_b1_leg_lambda_platform_norm - w_357
            - k_lambda_b1_leg_lambda_a1_leg * l_lambda_b1_leg_lambda_a1_leg
            - k_lambda_b1_leg_lambda_a2_leg * l_lambda_b1_leg_lambda_a2_leg;
        let inverse_lambda_b1_leg = S::from_f64(1.0) / pivot_lambda_b1_leg;
        let k_lambda_b2_leg_lambda_b1_leg = k_lambda_b1_leg_lambda_platform_norm
            * minus_l_lambda_b2_leg_lambda_platform_norm
            - b1_leg_by_platform_q0 * l_lambda_b2_leg_platform_q0
            - k_lambda_b1_leg_platform_q1 * l_lambda_b2_leg_platform_q1
            - k_lambda_b1_leg_platform_q2 * l_lambda_b2_leg_platform_q2
            - minus_k_lambda_b1_leg_platform_q3 * minus_l_lambda_b2_leg_platform_q3
            - b1_leg_by_platform_x * l_lambda_b2_leg_platform_x
            - b1_leg_by_platform_y * l_lambda_b2_leg_platform_y
            - b1_leg_by_platform_z * l_lambda_b2_leg_platform_z
            - k_lambda_b1_leg_lambda_a1_leg * l_lambda_b2_leg_lambda_a1_leg
            - k_lambda_b1_leg_lambda_a2_leg * l_lambda_b2_leg_lambda_a2_leg;
        let l_lambda_b2_leg_lambda_b1_leg = inverse_lambda_b1_leg
            * k_lambda_b2_leg_lambda_b1_leg;
        let rhs_lambda_b2_leg = l_lambda_b2_leg_platform_q2 * minus_rhs_platform_q2
            - (sqrt_w_298 * w_355 + w_226 - w_356)
            - rhs_platform_q0 * l_lambda_b2_leg_platform_q0
            - l_lambda_b2_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_b2_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_b2_leg_platform_z
            + minus_l_lambda_b2_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_b2_leg_lambda_a1_leg * rhs_lambda_a1_leg
            - l_lambda_b2_leg_lambda_a2_leg * rhs_lambda_a2_leg
            - l_lambda_b2_leg_lambda_b1_leg * rhs_lambda_b1_leg;
        let w_358 = w_39 * self.k_34;
        let w_359 = platform_x - self.k_32 - w_36 * self.k_33 + w * w_358;
        let w_360 = w_42 * self.k_36;
        let w_361 = platform_y - self.k_35 + w * w_360 - w_45 * self.k_37;
        let w_362 = w_47 * self.k_36 + w_48 * self.k_34;
        let c1_on_platform_z = w * w_362 + platform_z;
        let w_363 = w_359 * w_359 + w_361 * w_361 + c1_on_platform_z * c1_on_platform_z;
        let sqrt_w_363 = w_363.sqrt();
        let w_364 = platform_q1 * self.k_37;
        let w_365 = w * w_364 - w_53 * self.k_36 - w_squared * w_54 * self.k_34;
        let w_366 = w_squared * (w_44 * self.k_34 - w_360);
        let w_367 = platform_q1 * self.k_33;
        let w_368 = platform_q2 * w_366 + w * w_367;
        let w_369 = platform_q3 * self.k_37;
        let w_370 = platform_q0 * self.k_33;
        let w_371 = w_squared * w_362;
        let w_372 = w * (w_369 - w_370) - platform_q2 * w_371;
        let w_373 = w_359 * w_365 + w_361 * w_368 + c1_on_platform_z * w_372;
        let w_374 = w_squared * (w_35 * self.k_36 - w_358);
        let w_375 = platform_q0 * w_374 - w * w_369;
        let w_376 = platform_q3 * self.k_33;
        let w_377 = platform_q0 * w_366 + w * w_376;
        let w_378 = platform_q2 * self.k_33;
        let w_379 = platform_q0 * w_371 + w * (w_378 - w_364);
        let w_380 = w_359 * w_375 + w_361 * w_377 - c1_on_platform_z * w_379;
        let c1_leg_by_platform_q0 = S::from_f64(2.0) * sqrt_w_363 * w_380 / w_363;
        let l_lambda_c1_leg_platform_q0 = c1_leg_by_platform_q0 * inverse_platform_q0;
        let w_381 = platform_q2 * self.k_37;
        let w_382 = platform_q1 * w_374 + w * w_381;
        let w_383 = w * w_378 - w_squared * w_73 * self.k_36 - w_75 * self.k_34;
        let w_384 = platform_q0 * self.k_37;
        let w_385 = w * (w_376 + w_384) - platform_q1 * w_371;
        let w_386 = w_359 * w_382 + w_361 * w_383 + c1_on_platform_z * w_385;
        let k_lambda_c1_leg_platform_q1 = S::from_f64(2.0) * sqrt_w_363 * w_386 / w_363
            - mass_platform_q1_platform_q0 * l_lambda_c1_leg_platform_q0;
        let l_lambda_c1_leg_platform_q1 = inverse_platform_q1
            * k_lambda_c1_leg_platform_q1;
        let k_lambda_c1_leg_platform_q2 = S::from_f64(2.0) * sqrt_w_363 * w_373 / w_363
            - mass_platform_q2_platform_q0 * l_lambda_c1_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_c1_leg_platform_q1;
        let l_lambda_c1_leg_platform_q2 = inverse_platform_q2
            * k_lambda_c1_leg_platform_q2;
        let w_387 = platform_x_dot + w_81 * self.k_67 - w_squared * w_82 * self.k_68
            - w * self.k_34 * w_83;
        let w_388 = platform_y_dot + w * self.k_36 * w_85 - w_squared * w_86 * self.k_67
            + w_88 * self.k_68;
        let w_389 = w * (self.k_34 * w_90 - self.k_36 * w_91)
            - w_squared * w_20 * (w_47 * self.k_67 + w_48 * self.k_68) + platform_z_dot;
        let w_390 = w_359 * w_387 + w_361 * w_388 + c1_on_platform_z * w_389;
        let w_391 = w * w_384 + w_94 * self.k_36 + w_squared * w_95 * self.k_34;
        let w_392 = w * w_370 - w_squared * w_97 * self.k_36 - w_98 * self.k_34;
        let w_393 = w * (w_381 + w_367) - platform_q3 * w_371;
        let w_394 = w_359 * w_391 - w_361 * w_392 - c1_on_platform_z * w_393;
        let w_363_squared = w_363 * w_363;
        let w_395 = w_390
            * ((w_394 * platform_q3_dot - w_380 * platform_q0_dot
                - w_386 * platform_q1_dot - w_373 * platform_q2_dot) / w_363_squared);
        let w_396 = w_20 * w_24 * (w_39 * self.k_70 - w_35 * self.k_69);
        let w_397 = self.k_37 * platform_q3_dot;
        let w_398 = w_359
            * (w_squared
                * (self.k_34 * w_104 + w_35 * self.k_36 * platform_q0_dot
                    + platform_q0 * w_80 * self.k_67) + platform_q0 * w_396 - w * w_397);
        let w_399 = w_20 * w_24 * (w_42 * self.k_69 - w_44 * self.k_70);
        let w_400 = self.k_33 * platform_q3_dot;
        let w_401 = w_361
            * (w_squared
                * (w_44 * self.k_34 * platform_q0_dot - self.k_36 * w_108
                    + platform_q0 * w_87 * self.k_68) + platform_q0 * w_399 + w * w_400);
        let w_402 = w_20 * w_24 * (w_47 * self.k_69 + w_48 * self.k_70);
        let w_403 = self.k_33 * platform_q2_dot;
        let w_404 = self.k_37 * platform_q1_dot;
        let w_405 = w_375 * w_387 + w_398 + w_377 * w_388 + w_401 - w_379 * w_389
            - c1_on_platform_z
                * (w_squared * (self.k_36 * w_113 + self.k_34 * w_115)
                    - platform_q0 * w_402 + w * (w_403 - w_404));
        let w_406 = self.k_37 * platform_q2_dot;
        let w_407 = w_359
            * (w_squared
                * (self.k_34 * w_120 + w_35 * self.k_36 * platform_q1_dot
                    + platform_q1 * w_80 * self.k_67) + platform_q1 * w_396 + w * w_406);
        let w_408 = self.k_37 * platform_q0_dot;
        let w_409 = c1_on_platform_z
            * (w_squared * (self.k_36 * w_128 - self.k_34 * w_130) + w * (w_400 + w_408)
                + platform_q1 * w_402);
        let w_410 = w_382 * w_387 + w_407 + w_383 * w_388
            + w_361
                * (w * w_403 - self.k_36 * w_123 + w_24 * w_124 * self.k_69
                    - self.k_34 * w_127) + w_385 * w_389 + w_409;
        let w_411 = self.k_33 * platform_q1_dot;
        let w_412 = w_361
            * (w_squared
                * (w_44 * self.k_34 * platform_q2_dot - self.k_36 * w_138
                    + platform_q2 * w_87 * self.k_68) + platform_q2 * w_399 + w * w_411);
        let w_413 = self.k_33 * platform_q0_dot;
        let w_414 = c1_on_platform_z
            * (w_squared * (self.k_36 * w_141 - self.k_34 * w_142) + w * (w_397 - w_413)
                + platform_q2 * w_402);
        let w_415 = w_365 * w_387
            + w_359
                * (self.k_34 * w_134 + w * w_404 - self.k_36 * w_136
                    + w_24 * w_137 * self.k_70) + w_368 * w_388 + w_412 + w_372 * w_389
            + w_414;
        let w_416 = w_361
            * (w * w_413 - self.k_36 * w_149 + w_24 * w_150 * self.k_69
                - self.k_34 * w_151);
        let w_417 = c1_on_platform_z
            * (w_squared * (self.k_36 * w_153 - self.k_34 * w_154) + w * (w_406 + w_411)
                + platform_q3 * w_402);
        let w_418 = w_391 * w_387
            + w_359
                * (self.k_34 * w_146 + w * w_408 + self.k_36 * w_147
                    - w_24 * w_148 * self.k_70) - w_392 * w_388 - w_416 - w_393 * w_389
            - w_417;
        let w_419 = S::from_f64(2.0)
            * (w_395
                + (platform_q0_dot * w_405 + platform_q1_dot * w_410
                    + platform_q2_dot * w_415 - platform_q3_dot * w_418) / w_363);
        let w_420 = w_419
            + (platform_x_dot * w_387 + platform_y_dot * w_388 + platform_z_dot * w_389)
                / w_363
            - w_390
                * ((w_359 * platform_x_dot + w_361 * platform_y_dot
                    + c1_on_platform_z * platform_z_dot) / w_363_squared);
        let minus_k_lambda_c1_leg_platform_q3 = S::from_f64(2.0) * sqrt_w_363 * w_394
            / w_363 + mass_platform_q3_platform_q0 * l_lambda_c1_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_c1_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_c1_leg_platform_q2;
        let minus_l_lambda_c1_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_c1_leg_platform_q3;
        let c1_leg_by_platform_z = c1_on_platform_z * sqrt_w_363 / w_363;
        let l_lambda_c1_leg_platform_z = c1_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_c1_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_c1_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_c1_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_c1_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_c1_leg_platform_q2;
        let minus_l_lambda_c1_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_c1_leg_lambda_platform_norm;
        let c1_leg_by_platform_x = w_359 * sqrt_w_363 / w_363;
        let l_lambda_c1_leg_platform_x = c1_leg_by_platform_x * self.inverse_platform_x;
        let c1_leg_by_platform_y = w_361 * sqrt_w_363 / w_363;
        let l_lambda_c1_leg_platform_y = c1_leg_by_platform_y * self.inverse_platform_x;
        let k_lambda_c1_leg_lambda_a1_leg = k_lambda_a1_leg_lambda_platform_norm
            * minus_l_lambda_c1_leg_lambda_platform_norm
            - a1_leg_by_platform_q0 * l_lambda_c1_leg_platform_q0
            - k_lambda_a1_leg_platform_q1 * l_lambda_c1_leg_platform_q1
            - k_lambda_a1_leg_platform_q2 * l_lambda_c1_leg_platform_q2
            - minus_k_lambda_a1_leg_platform_q3 * minus_l_lambda_c1_leg_platform_q3
            - a1_leg_by_platform_x * l_lambda_c1_leg_platform_x
            - a1_leg_by_platform_y * l_lambda_c1_leg_platform_y
            - a1_leg_by_platform_z * l_lambda_c1_leg_platform_z;
        let l_lambda_c1_leg_lambda_a1_leg = inverse_lambda_a1_leg
            * k_lambda_c1_leg_lambda_a1_leg;
        let k_lambda_c1_leg_lambda_a2_leg = k_lambda_a2_leg_lambda_platform_norm
            * minus_l_lambda_c1_leg_lambda_platform_norm
            - a2_leg_by_platform_q0 * l_lambda_c1_leg_platform_q0
            - k_lambda_a2_leg_platform_q1 * l_lambda_c1_leg_platform_q1
            - k_lambda_a2_leg_platform_q2 * l_lambda_c1_leg_platform_q2
            - minus_k_lambda_a2_leg_platform_q3 * minus_l_lambda_c1_leg_platform_q3
            - a2_leg_by_platform_x * l_lambda_c1_leg_platform_x
            - a2_leg_by_platform_y * l_lambda_c1_leg_platform_y
            - a2_leg_by_platform_z * l_lambda_c1_leg_platform_z
            - k_lambda_a2_leg_lambda_a1_leg * l_lambda_c1_leg_lambda_a1_leg;
        let l_lambda_c1_leg_lambda_a2_leg = inverse_lambda_a2_leg
            * k_lambda_c1_leg_lambda_a2_leg;
        let k_lambda_c1_leg_lambda_b1_leg = k_lambda_b1_leg_lambda_platform_norm
            * minus_l_lambda_c1_leg_lambda_platform_norm
            - b1_leg_by_platform_q0 * l_lambda_c1_leg_platform_q0
            - k_lambda_b1_leg_platform_q1 * l_lambda_c1_leg_platform_q1
            - k_lambda_b1_leg_platform_q2 * l_lambda_c1_leg_platform_q2
            - minus_k_lambda_b1_leg_platform_q3 * minus_l_lambda_c1_leg_platform_q3
            - b1_leg_by_platform_x * l_lambda_c1_leg_platform_x
            - b1_leg_by_platform_y * l_lambda_c1_leg_platform_y
            - b1_leg_by_platform_z * l_lambda_c1_leg_platform_z
            - k_lambda_b1_leg_lambda_a1_leg * l_lambda_c1_leg_lambda_a1_leg
            - k_lambda_b1_leg_lambda_a2_leg * l_lambda_c1_leg_lambda_a2_leg;
        let l_lambda_c1_leg_lambda_b1_leg = inverse_lambda_b1_leg
            * k_lambda_c1_leg_lambda_b1_leg;
        let w_421 = b2_leg_by_platform_q0 * l_lambda_b2_leg_platform_q0
            + k_lambda_b2_leg_platform_q1 * l_lambda_b2_leg_platform_q1
            + k_lambda_b2_leg_platform_q2 * l_lambda_b2_leg_platform_q2
            + minus_k_lambda_b2_leg_platform_q3 * minus_l_lambda_b2_leg_platform_q3
            + b2_leg_by_platform_x * l_lambda_b2_leg_platform_x
            + b2_leg_by_platform_y * l_lambda_b2_leg_platform_y
            + b2_leg_by_platform_z * l_lambda_b2_leg_platform_z;
        let pivot_lambda_b2_leg = k_lambda_b2_leg_lambda_platform_norm
            * minus_l_lambda_b2_leg_lambda_platform_norm - w_421
            - k_lambda_b2_leg_lambda_a1_leg * l_lambda_b2_leg_lambda_a1_leg
            - k_lambda_b2_leg_lambda_a2_leg * l_lambda_b2_leg_lambda_a2_leg
            - k_lambda_b2_leg_lambda_b1_leg * l_lambda_b2_leg_lambda_b1_leg;
        let inverse_lambda_b2_leg = S::from_f64(1.0) / pivot_lambda_b2_leg;
        let k_lambda_c1_leg_lambda_b2_leg = k_lambda_b2_leg_lambda_platform_norm
            * minus_l_lambda_c1_leg_lambda_platform_norm
            - b2_leg_by_platform_q0 * l_lambda_c1_leg_platform_q0
            - k_lambda_b2_leg_platform_q1 * l_lambda_c1_leg_platform_q1
            - k_lambda_b2_leg_platform_q2 * l_lambda_c1_leg_platform_q2
            - minus_k_lambda_b2_leg_platform_q3 * minus_l_lambda_c1_leg_platform_q3
            - b2_leg_by_platform_x * l_lambda_c1_leg_platform_x
            - b2_leg_by_platform_y * l_lambda_c1_leg_platform_y
            - b2_leg_by_platform_z * l_lambda_c1_leg_platform_z
            - k_lambda_b2_leg_lambda_a1_leg * l_lambda_c1_leg_lambda_a1_leg
            - k_lambda_b2_leg_lambda_a2_leg * l_lambda_c1_leg_lambda_a2_leg
            - k_lambda_b2_leg_lambda_b1_leg * l_lambda_c1_leg_lambda_b1_leg;
        let l_lambda_c1_leg_lambda_b2_leg = inverse_lambda_b2_leg
            * k_lambda_c1_leg_lambda_b2_leg;
        let rhs_lambda_c1_leg = l_lambda_c1_leg_platform_q2 * minus_rhs_platform_q2
            - (sqrt_w_363 * w_420 + w_226 + w_356)
            - rhs_platform_q0 * l_lambda_c1_leg_platform_q0
            - l_lambda_c1_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_c1_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_c1_leg_platform_z
            + minus_l_lambda_c1_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_c1_leg_lambda_a1_leg * rhs_lambda_a1_leg
            - l_lambda_c1_leg_lambda_a2_leg * rhs_lambda_a2_leg
            - l_lambda_c1_leg_lambda_b1_leg * rhs_lambda_b1_leg
            - l_lambda_c1_leg_lambda_b2_leg * rhs_lambda_b2_leg;
        let w_422 = w_39 * self.k_41;
        let w_423 = platform_x - self.k_39 - w_36 * self.k_40 + w * w_422;
        let w_424 = w_42 * self.k_43;
        let w_425 = platform_y - self.k_42 + w * w_424 - w_45 * self.k_44;
        let w_426 = w_47 * self.k_43 + w_48 * self.k_41;
        let c2_on_platform_z = w * w_426 + platform_z;
        let w_427 = w_423 * w_423 + w_425 * w_425 + c2_on_platform_z * c2_on_platform_z;
        let sqrt_w_427 = w_427.sqrt();
        let w_428 = platform_q1 * self.k_44;
        let w_429 = w * w_428 - w_53 * self.k_43 - w_squared * w_54 * self.k_41;
        let w_430 = w_squared * (w_44 * self.k_41 - w_424);
        let w_431 = platform_q1 * self.k_40;
        let w_432 = platform_q2 * w_430 + w * w_431;
        let w_433 = platform_q3 * self.k_44;
        let w_434 = platform_q0 * self.k_40;
        let w_435 = w_squared * w_426;
        let w_436 = w * (w_433 - w_434) - platform_q2 * w_435;
        let w_437 = w_423 * w_429 + w_425 * w_432 + c2_on_platform_z * w_436;
        let w_438 = w_squared * (w_35 * self.k_43 - w_422);
        let w_439 = platform_q0 * w_438 - w * w_433;
        let w_440 = platform_q3 * self.k_40;
        let w_441 = platform_q0 * w_430 + w * w_440;
        let w_442 = platform_q2 * self.k_40;
        let w_443 = platform_q0 * w_435 + w * (w_442 - w_428);
        let w_444 = w_423 * w_439 + w_425 * w_441 - c2_on_platform_z * w_443;
        let c2_leg_by_platform_q0 = S::from_f64(2.0) * sqrt_w_427 * w_444 / w_427;
        let l_lambda_c2_leg_platform_q0 = c2_leg_by_platform_q0 * inverse_platform_q0;
        let w_445 = platform_q2 * self.k_44;
        let w_446 = platform_q1 * w_438 + w * w_445;
        let w_447 = w * w_442 - w_squared * w_73 * self.k_43 - w_75 * self.k_41;
        let w_448 = platform_q0 * self.k_44;
        let w_449 = w * (w_440 + w_448) - platform_q1 * w_435;
        let w_450 = w_423 * w_446 + w_425 * w_447 + c2_on_platform_z * w_449;
        let k_lambda_c2_leg_platform_q1 = S::from_f64(2.0) * sqrt_w_427 * w_450 / w_427
            - mass_platform_q1_platform_q0 * l_lambda_c2_leg_platform_q0;
        let l_lambda_c2_leg_platform_q1 = inverse_platform_q1
            * k_lambda_c2_leg_platform_q1;
        let k_lambda_c2_leg_platform_q2 = S::from_f64(2.0) * sqrt_w_427 * w_437 / w_427
            - mass_platform_q2_platform_q0 * l_lambda_c2_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_c2_leg_platform_q1;
        let l_lambda_c2_leg_platform_q2 = inverse_platform_q2
            * k_lambda_c2_leg_platform_q2;
        let w_451 = platform_x_dot + w_81 * self.k_71 - w_squared * w_82 * self.k_72
            - w * self.k_41 * w_83;
        let w_452 = platform_y_dot + w * self.k_43 * w_85 - w_squared * w_86 * self.k_71
            + w_88 * self.k_72;
        let w_453 = w * (self.k_41 * w_90 - self.k_43 * w_91)
            - w_squared * w_20 * (w_47 * self.k_71 + w_48 * self.k_72) + platform_z_dot;
        let w_454 = w_423 * w_451 + w_425 * w_452 + c2_on_platform_z * w_453;
        let w_455 = w * w_448 + w_94 * self.k_43 + w_squared * w_95 * self.k_41;
        let w_456 = w * w_434 - w_squared * w_97 * self.k_43 - w_98 * self.k_41;
        let w_457 = w * (w_445 + w_431) - platform_q3 * w_435;
        let w_458 = w_423 * w_455 - w_425 * w_456 - c2_on_platform_z * w_457;
        let w_427_squared = w_427 * w_427;
        let w_459 = w_454
            * ((w_458 * platform_q3_dot - w_444 * platform_q0_dot
                - w_450 * platform_q1_dot - w_437 * platform_q2_dot) / w_427_squared);
        let w_460 = w_20 * w_24 * (w_39 * self.k_74 - w_35 * self.k_73);
        let w_461 = self.k_44 * platform_q3_dot;
        let w_462 = w_423
            * (w_squared
                * (self.k_41 * w_104 + w_35 * self.k_43 * platform_q0_dot
                    + platform_q0 * w_80 * self.k_71) + platform_q0 * w_460 - w * w_461);
        let w_463 = w_20 * w_24 * (w_42 * self.k_73 - w_44 * self.k_74);
        let w_464 = self.k_40 * platform_q3_dot;
        let w_465 = w_425
            * (w_squared
                * (w_44 * self.k_41 * platform_q0_dot - self.k_43 * w_108
                    + platform_q0 * w_87 * self.k_72) + platform_q0 * w_463 + w * w_464);
        let w_466 = w_20 * w_24 * (w_47 * self.k_73 + w_48 * self.k_74);
        let w_467 = self.k_40 * platform_q2_dot;
        let w_468 = self.k_44 * platform_q1_dot;
        let w_469 = w_439 * w_451 + w_462 + w_441 * w_452 + w_465 - w_443 * w_453
            - c2_on_platform_z
                * (w_squared * (self.k_43 * w_113 + self.k_41 * w_115)
                    - platform_q0 * w_466 + w * (w_467 - w_468));
        let w_470 = self.k_44 * platform_q2_dot;
        let w_471 = w_423
            * (w_squared
                * (self.k_41 * w_120 + w_35 * self.k_43 * platform_q1_dot
                    + platform_q1 * w_80 * self.k_71) + platform_q1 * w_460 + w * w_470);
        let w_472 = self.k_44 * platform_q0_dot;
        let w_473 = c2_on_platform_z
            * (w_squared * (self.k_43 * w_128 - self.k_41 * w_130) + w * (w_464 + w_472)
                + platform_q1 * w_466);
        let w_474 = w_446 * w_451 + w_471 + w_447 * w_452
            + w_425
                * (w * w_467 - self.k_43 * w_123 + w_24 * w_124 * self.k_73
                    - self.k_41 * w_127) + w_449 * w_453 + w_473;
        let w_475 = self.k_40 * platform_q1_dot;
        let w_476 = w_425
            * (w_squared
                * (w_44 * self.k_41 * platform_q2_dot - self.k_43 * w_138
                    + platform_q2 * w_87 * self.k_72) + platform_q2 * w_463 + w * w_475);
        let w_477 = self.k_40 * platform_q0_dot;
        let w_478 = c2_on_platform_z
            * (w_squared * (self.k_43 * w_141 - self.k_41 * w_142) + w * (w_461 - w_477)
                + platform_q2 * w_466);
        let w_479 = w_429 * w_451
            + w_423
                * (self.k_41 * w_134 + w * w_468 - self.k_43 * w_136
                    + w_24 * w_137 * self.k_74) + w_432 * w_452 + w_476 + w_436 * w_453
            + w_478;
        let w_480 = w_425
            * (w * w_477 - self.k_43 * w_149 + w_24 * w_150 * self.k_73
                - self.k_41 * w_151);
        let w_481 = c2_on_platform_z
            * (w_squared * (self.k_43 * w_153 - self.k_41 * w_154) + w * (w_470 + w_475)
                + platform_q3 * w_466);
        let w_482 = w_455 * w_451
            + w_423
                * (self.k_41 * w_146 + w * w_472 + self.k_43 * w_147
                    - w_24 * w_148 * self.k_74) - w_456 * w_452 - w_480 - w_457 * w_453
            - w_481;
        let w_483 = S::from_f64(2.0)
            * (w_459
                + (platform_q0_dot * w_469 + platform_q1_dot * w_474
                    + platform_q2_dot * w_479 - platform_q3_dot * w_482) / w_427);
        let w_484 = w_483
            + (platform_x_dot * w_451 + platform_y_dot * w_452 + platform_z_dot * w_453)
                / w_427
            - w_454
                * ((w_423 * platform_x_dot + w_425 * platform_y_dot
                    + c2_on_platform_z * platform_z_dot) / w_427_squared);
        let w_485 = sqrt_w_427 * w_484 + w_226 - self.k_53 * sin_w_162;
        let minus_k_lambda_c2_leg_platform_q3 = S::from_f64(2.0) * sqrt_w_427 * w_458
            / w_427 + mass_platform_q3_platform_q0 * l_lambda_c2_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_c2_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_c2_leg_platform_q2;
        let minus_l_lambda_c2_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_c2_leg_platform_q3;
        let c2_leg_by_platform_z = c2_on_platform_z * sqrt_w_427 / w_427;
        let l_lambda_c2_leg_platform_z = c2_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_c2_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_c2_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_c2_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_c2_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_c2_leg_platform_q2;
        let minus_l_lambda_c2_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_c2_leg_lambda_platform_norm;
        let c2_leg_by_platform_x = w_423 * sqrt_w_427 / w_427;
        let l_lambda_c2_leg_platform_x = c2_leg_by_platform_x * self.inverse_platform_x;
        let c2_leg_by_platform_y = w_425 * sqrt_w_427 / w_427;
        let l_lambda_c2_leg_platform_y = c2_leg_by_platform_y * self.inverse_platform_x;
        let k_lambda_c2_leg_lambda_a1_leg = k_lambda_a1_leg_lambda_platform_norm
            * minus_l_lambda_c2_leg_lambda_platform_norm
            - a1_leg_by_platform_q0 * l_lambda_c2_leg_platform_q0
            - k_lambda_a1_leg_platform_q1 * l_lambda_c2_leg_platform_q1
            - k_lambda_a1_leg_platform_q2 * l_lambda_c2_leg_platform_q2
            - minus_k_lambda_a1_leg_platform_q3 * minus_l_lambda_c2_leg_platform_q3
            - a1_leg_by_platform_x * l_lambda_c2_leg_platform_x
            - a1_leg_by_platform_y * l_lambda_c2_leg_platform_y
            - a1_leg_by_platform_z * l_lambda_c2_leg_platform_z;
        let l_lambda_c2_leg_lambda_a1_leg = inverse_lambda_a1_leg
            * k_lambda_c2_leg_lambda_a1_leg;
        let k_lambda_c2_leg_lambda_a2_leg = k_lambda_a2_leg_lambda_platform_norm
            * minus_l_lambda_c2_leg_lambda_platform_norm
            - a2_leg_by_platform_q0 * l_lambda_c2_leg_platform_q0
            - k_lambda_a2_leg_platform_q1 * l_lambda_c2_leg_platform_q1
            - k_lambda_a2_leg_platform_q2 * l_lambda_c2_leg_platform_q2
            - minus_k_lambda_a2_leg_platform_q3 * minus_l_lambda_c2_leg_platform_q3
            - a2_leg_by_platform_x * l_lambda_c2_leg_platform_x
            - a2_leg_by_platform_y * l_lambda_c2_leg_platform_y
            - a2_leg_by_platform_z * l_lambda_c2_leg_platform_z
            - k_lambda_a2_leg_lambda_a1_leg * l_lambda_c2_leg_lambda_a1_leg;
        let l_lambda_c2_leg_lambda_a2_leg = inverse_lambda_a2_leg
            * k_lambda_c2_leg_lambda_a2_leg;
        let k_lambda_c2_leg_lambda_b1_leg = k_lambda_b1_leg_lambda_platform_norm
            * minus_l_lambda_c2_leg_lambda_platform_norm
            - b1_leg_by_platform_q0 * l_lambda_c2_leg_platform_q0
            - k_lambda_b1_leg_platform_q1 * l_lambda_c2_leg_platform_q1
            - k_lambda_b1_leg_platform_q2 * l_lambda_c2_leg_platform_q2
            - minus_k_lambda_b1_leg_platform_q3 * minus_l_lambda_c2_leg_platform_q3
            - b1_leg_by_platform_x * l_lambda_c2_leg_platform_x
            - b1_leg_by_platform_y * l_lambda_c2_leg_platform_y
            - b1_leg_by_platform_z * l_lambda_c2_leg_platform_z
            - k_lambda_b1_leg_lambda_a1_leg * l_lambda_c2_leg_lambda_a1_leg
            - k_lambda_b1_leg_lambda_a2_leg * l_lambda_c2_leg_lambda_a2_leg;
        let l_lambda_c2_leg_lambda_b1_leg = inverse_lambda_b1_leg
            * k_lambda_c2_leg_lambda_b1_leg;
        let k_lambda_c2_leg_lambda_b2_leg = k_lambda_b2_leg_lambda_platform_norm
            * minus_l_lambda_c2_leg_lambda_platform_norm
            - b2_leg_by_platform_q0 * l_lambda_c2_leg_platform_q0
            - k_lambda_b2_leg_platform_q1 * l_lambda_c2_leg_platform_q1
            - k_lambda_b2_leg_platform_q2 * l_lambda_c2_leg_platform_q2
            - minus_k_lambda_b2_leg_platform_q3 * minus_l_lambda_c2_leg_platform_q3
            - b2_leg_by_platform_x * l_lambda_c2_leg_platform_x
            - b2_leg_by_platform_y * l_lambda_c2_leg_platform_y
            - b2_leg_by_platform_z * l_lambda_c2_leg_platform_z
            - k_lambda_b2_leg_lambda_a1_leg * l_lambda_c2_leg_lambda_a1_leg
            - k_lambda_b2_leg_lambda_a2_leg * l_lambda_c2_leg_lambda_a2_leg
            - k_lambda_b2_leg_lambda_b1_leg * l_lambda_c2_leg_lambda_b1_leg;
        let l_lambda_c2_leg_lambda_b2_leg = inverse_lambda_b2_leg
            * k_lambda_c2_leg_lambda_b2_leg;
        let w_486 = c1_leg_by_platform_q0 * l_lambda_c1_leg_platform_q0
            + k_lambda_c1_leg_platform_q1 * l_lambda_c1_leg_platform_q1
            + k_lambda_c1_leg_platform_q2 * l_lambda_c1_leg_platform_q2
            + minus_k_lambda_c1_leg_platform_q3 * minus_l_lambda_c1_leg_platform_q3
            + c1_leg_by_platform_x * l_lambda_c1_leg_platform_x
            + c1_leg_by_platform_y * l_lambda_c1_leg_platform_y
            + c1_leg_by_platform_z * l_lambda_c1_leg_platform_z;
        let pivot_lambda_c1_leg = k_lambda_c1_leg_lambda_platform_norm
            * minus_l_lambda_c1_leg_lambda_platform_norm - w_486
            - k_lambda_c1_leg_lambda_a1_leg * l_lambda_c1_leg_lambda_a1_leg
            - k_lambda_c1_leg_lambda_a2_leg * l_lambda_c1_leg_lambda_a2_leg
            - k_lambda_c1_leg_lambda_b1_leg * l_lambda_c1_leg_lambda_b1_leg
            - k_lambda_c1_leg_lambda_b2_leg * l_lambda_c1_leg_lambda_b2_leg;
        let inverse_lambda_c1_leg = S::from_f64(1.0) / pivot_lambda_c1_leg;
        let k_lambda_c2_leg_lambda_c1_leg = k_lambda_c1_leg_lambda_platform_norm
            * minus_l_lambda_c2_leg_lambda_platform_norm
            - c1_leg_by_platform_q0 * l_lambda_c2_leg_platform_q0
            - k_lambda_c1_leg_platform_q1 * l_lambda_c2_leg_platform_q1
            - k_lambda_c1_leg_platform_q2 * l_lambda_c2_leg_platform_q2
            - minus_k_lambda_c1_leg_platform_q3 * minus_l_lambda_c2_leg_platform_q3
            - c1_leg_by_platform_x * l_lambda_c2_leg_platform_x
            - c1_leg_by_platform_y * l_lambda_c2_leg_platform_y
            - c1_leg_by_platform_z * l_lambda_c2_leg_platform_z
            - k_lambda_c1_leg_lambda_a1_leg * l_lambda_c2_leg_lambda_a1_leg
            - k_lambda_c1_leg_lambda_a2_leg * l_lambda_c2_leg_lambda_a2_leg
            - k_lambda_c1_leg_lambda_b1_leg * l_lambda_c2_leg_lambda_b1_leg
            - k_lambda_c1_leg_lambda_b2_leg * l_lambda_c2_leg_lambda_b2_leg;
        let l_lambda_c2_leg_lambda_c1_leg = inverse_lambda_c1_leg
            * k_lambda_c2_leg_lambda_c1_leg;
        let rhs_lambda_c2_leg = l_lambda_c2_leg_platform_q2 * minus_rhs_platform_q2
            - w_485 - rhs_platform_q0 * l_lambda_c2_leg_platform_q0
            - l_lambda_c2_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_c2_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_c2_leg_platform_z
            + minus_l_lambda_c2_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_c2_leg_lambda_a1_leg * rhs_lambda_a1_leg
            - l_lambda_c2_leg_lambda_a2_leg * rhs_lambda_a2_leg
            - l_lambda_c2_leg_lambda_b1_leg * rhs_lambda_b1_leg
            - l_lambda_c2_leg_lambda_b2_leg * rhs_lambda_b2_leg
            - l_lambda_c2_leg_lambda_c1_leg * rhs_lambda_c1_leg;
        let w_487 = c2_leg_by_platform_q0 * l_lambda_c2_leg_platform_q0
            + k_lambda_c2_leg_platform_q1 * l_lambda_c2_leg_platform_q1
            + k_lambda_c2_leg_platform_q2 * l_lambda_c2_leg_platform_q2
            + minus_k_lambda_c2_leg_platform_q3 * minus_l_lambda_c2_leg_platform_q3
            + c2_leg_by_platform_x * l_lambda_c2_leg_platform_x
            + c2_leg_by_platform_y * l_lambda_c2_leg_platform_y
            + c2_leg_by_platform_z * l_lambda_c2_leg_platform_z;
        let pivot_lambda_c2_leg = k_lambda_c2_leg_lambda_platform_norm
            * minus_l_lambda_c2_leg_lambda_platform_norm - w_487
            - k_lambda_c2_leg_lambda_a1_leg * l_lambda_c2_leg_lambda_a1_leg
            - k_lambda_c2_leg_lambda_a2_leg * l_lambda_c2_leg_lambda_a2_leg
            - k_lambda_c2_leg_lambda_b1_leg * l_lambda_c2_leg_lambda_b1_leg
            - k_lambda_c2_leg_lambda_b2_leg * l_lambda_c2_leg_lambda_b2_leg
            - k_lambda_c2_leg_lambda_c1_leg * l_lambda_c2_leg_lambda_c1_leg;
        let lambda_c2_leg = S::from_f64(1.0) / pivot_lambda_c2_leg * rhs_lambda_c2_leg;
        let lambda_c1_leg = inverse_lambda_c1_leg * rhs_lambda_c1_leg
            - l_lambda_c2_leg_lambda_c1_leg * lambda_c2_leg;
        let lambda_b2_leg = inverse_lambda_b2_leg * rhs_lambda_b2_leg
            - l_lambda_c1_leg_lambda_b2_leg * lambda_c1_leg
            - l_lambda_c2_leg_lambda_b2_leg * lambda_c2_leg;
        let lambda_b1_leg = inverse_lambda_b1_leg * rhs_lambda_b1_leg
            - l_lambda_b2_leg_lambda_b1_leg * lambda_b2_leg
            - l_lambda_c1_leg_lambda_b1_leg * lambda_c1_leg
            - l_lambda_c2_leg_lambda_b1_leg * lambda_c2_leg;
        let lambda_a2_leg = inverse_lambda_a2_leg * rhs_lambda_a2_leg
            - l_lambda_b1_leg_lambda_a2_leg * lambda_b1_leg
            - l_lambda_b2_leg_lambda_a2_leg * lambda_b2_leg
            - l_lambda_c1_leg_lambda_a2_leg * lambda_c1_leg
            - l_lambda_c2_leg_lambda_a2_leg * lambda_c2_leg;
        let lambda_a1_leg = inverse_lambda_a1_leg * rhs_lambda_a1_leg
            - l_lambda_a2_leg_lambda_a1_leg * lambda_a2_leg
            - l_lambda_b1_leg_lambda_a1_leg * lambda_b1_leg
            - l_lambda_b2_leg_lambda_a1_leg * lambda_b2_leg
            - l_lambda_c1_leg_lambda_a1_leg * lambda_c1_leg
            - l_lambda_c2_leg_lambda_a1_leg * lambda_c2_leg;
        let lambda_platform_norm = minus_l_lambda_a1_leg_lambda_platform_norm
            * lambda_a1_leg
            - minus_inverse_lambda_platform_norm * rhs_lambda_platform_norm
            + minus_l_lambda_a2_leg_lambda_platform_norm * lambda_a2_leg
            + minus_l_lambda_b1_leg_lambda_platform_norm * lambda_b1_leg
            + minus_l_lambda_b2_leg_lambda_platform_norm * lambda_b2_leg
            + minus_l_lambda_c1_leg_lambda_platform_norm * lambda_c1_leg
            + minus_l_lambda_c2_leg_lambda_platform_norm * lambda_c2_leg;
        let platform_q3_ddot = inverse_platform_q3 * rhs_platform_q3
            - l_lambda_platform_norm_platform_q3 * lambda_platform_norm
            + minus_l_lambda_a1_leg_platform_q3 * lambda_a1_leg
            + minus_l_lambda_a2_leg_platform_q3 * lambda_a2_leg
            + minus_l_lambda_b1_leg_platform_q3 * lambda_b1_leg
            + minus_l_lambda_b2_leg_platform_q3 * lambda_b2_leg
            + minus_l_lambda_c1_leg_platform_q3 * lambda_c1_leg
            + minus_l_lambda_c2_leg_platform_q3 * lambda_c2_leg;
        let minus_platform_q2_ddot = inverse_platform_q2 * minus_rhs_platform_q2
            + l_platform_q3_platform_q2 * platform_q3_ddot
            + l_lambda_platform_norm_platform_q2 * lambda_platform_norm
            + l_lambda_a1_leg_platform_q2 * lambda_a1_leg
            + l_lambda_a2_leg_platform_q2 * lambda_a2_leg
            + l_lambda_b1_leg_platform_q2 * lambda_b1_leg
            + l_lambda_b2_leg_platform_q2 * lambda_b2_leg
            + l_lambda_c1_leg_platform_q2 * lambda_c1_leg
            + l_lambda_c2_leg_platform_q2 * lambda_c2_leg;
        let platform_q1_ddot = inverse_platform_q1 * rhs_platform_q1
            + l_platform_q2_platform_q1 * minus_platform_q2_ddot
            - l_platform_q3_platform_q1 * platform_q3_ddot
            - l_lambda_platform_norm_platform_q1 * lambda_platform_norm
            - l_lambda_a1_leg_platform_q1 * lambda_a1_leg
            - l_lambda_a2_leg_platform_q1 * lambda_a2_leg
            - l_lambda_b1_leg_platform_q1 * lambda_b1_leg
            - l_lambda_b2_leg_platform_q1 * lambda_b2_leg
            - l_lambda_c1_leg_platform_q1 * lambda_c1_leg
            - l_lambda_c2_leg_platform_q1 * lambda_c2_leg;
        let w_488 = cos_w_159 * self.k_76;
        let w_489 = self.k_77 * cos_w_160;
        let w_490 = self.k_77 * cos_w_161;
        let w_491 = self.minus_rhs_platform_z * platform_z_dot
            + lambda_a1_leg * cos_w_159 * self.k_78 + lambda_a2_leg * (w_488 - w_489)
            + lambda_b1_leg * (w_488 + w_489) + lambda_b2_leg * (w_488 - w_490)
            + lambda_c1_leg * (w_488 + w_490)
            + lambda_c2_leg * (w_488 - self.k_77 * cos_w_162);
        sim_kernel::Dynamics {
            accelerations: [
                -(l_lambda_a1_leg_platform_x * lambda_a1_leg
                    + l_lambda_a2_leg_platform_x * lambda_a2_leg
                    + l_lambda_b1_leg_platform_x * lambda_b1_leg
                    + l_lambda_b2_leg_platform_x * lambda_b2_leg
                    + l_lambda_c1_leg_platform_x * lambda_c1_leg
                    + l_lambda_c2_leg_platform_x * lambda_c2_leg),
                -(l_lambda_a1_leg_platform_y * lambda_a1_leg
                    + l_lambda_a2_leg_platform_y * lambda_a2_leg
                    + l_lambda_b1_leg_platform_y * lambda_b1_leg
                    + l_lambda_b2_leg_platform_y * lambda_b2_leg
                    + l_lambda_c1_leg_platform_y * lambda_c1_leg
                    + l_lambda_c2_leg_platform_y * lambda_c2_leg),
                -(self.k_75 + l_lambda_a1_leg_platform_z * lambda_a1_leg
                    + l_lambda_a2_leg_platform_z * lambda_a2_leg
                    + l_lambda_b1_leg_platform_z * lambda_b1_leg
                    + l_lambda_b2_leg_platform_z * lambda_b2_leg
                    + l_lambda_c1_leg_platform_z * lambda_c1_leg
                    + l_lambda_c2_leg_platform_z * lambda_c2_leg),
                rhs_platform_q0 * inverse_platform_q0
                    - l_platform_q1_platform_q0 * platform_q1_ddot
                    + l_platform_q2_platform_q0 * minus_platform_q2_ddot
                    - l_platform_q3_platform_q0 * platform_q3_ddot
                    - l_lambda_platform_norm_platform_q0 * lambda_platform_norm
                    - l_lambda_a1_leg_platform_q0 * lambda_a1_leg
                    - l_lambda_a2_leg_platform_q0 * lambda_a2_leg
                    - l_lambda_b1_leg_platform_q0 * lambda_b1_leg
                    - l_lambda_b2_leg_platform_q0 * lambda_b2_leg
                    - l_lambda_c1_leg_platform_q0 * lambda_c1_leg
                    - l_lambda_c2_leg_platform_q0 * lambda_c2_leg,
                platform_q1_ddot,
                -minus_platform_q2_ddot,
                platform_q3_ddot,
            ],
            multipliers: [
                lambda_platform_norm,
                lambda_a1_leg,
                lambda_a2_leg,
                lambda_b1_leg,
                lambda_b2_leg,
                lambda_c1_leg,
                lambda_c2_leg,
            ],
            power: -w_491,
            refused: sim_kernel::pivot_is_refused(
                mass_platform_q0_platform_q0,
                mass_platform_q0_platform_q0,
            )
                | sim_kernel::pivot_is_refused(
                    pivot_platform_q1,
                    mass_platform_q1_platform_q1,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_platform_q2,
                    mass_platform_q2_platform_q2,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_platform_q3,
                    mass_platform_q3_platform_q3,
                ) | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_platform_norm,
                    minus_pivot_lambda_platform_norm,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_a1_leg, w_228)
                | sim_kernel::pivot_is_refused(pivot_lambda_a2_leg, w_292)
                | sim_kernel::pivot_is_refused(pivot_lambda_b1_leg, w_357)
                | sim_kernel::pivot_is_refused(pivot_lambda_b2_leg, w_421)
                | sim_kernel::pivot_is_refused(pivot_lambda_c1_leg, w_486)
                | sim_kernel::pivot_is_refused(pivot_lambda_c2_leg, w_487),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Stewart<S> {
    type Q = [S; 7];
    type L = [S; 7];
    type Z = [S; 14];
    type QQ = [[S; 7]; 7];
    type LQ = [[S; 7]; 7];
    type LL = [[S; 7]; 7];
    type ZZ = [[S; 14]; 14];
    type Parameters = [S; 12];
    type Outputs = [S; 4];
    type OutputRates = [S; 2];
    type Events = [S; 1];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 75];
    type QP = [[S; 12]; 7];
    type LP = [[S; 12]; 7];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = StewartPrepared<S>;
    type On<T: sim_kernel::Scalar> = Stewart<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "stewart",
        type_name: "Stewart",
        docs: "A platform on six legs that lengthen and shorten together, and swing apart.",
        declaration: "/// A platform on six legs that lengthen and shorten together, and swing apart.\npub Stewart;\n\nparameters {\n    m [kg] = 40;\n    /// Principal moments of inertia of the platform.\n    A [kg*m^2] = 3;\n    C [kg*m^2] = 5;\n    /// Radius of the circle of the feet.\n    R [m] = 0.9;\n    /// Radius of the circle of the heads.\n    r [m] = 0.5;\n    /// Half of the angle between the feet of a pair.\n    foot [deg] = 10;\n    /// Half of the angle between the heads of a pair.\n    head [deg] = 12;\n    /// Length of the legs at rest.\n    L [m] = 1;\n    /// How far all legs move together.\n    heave [m] = 0.1;\n    /// How far neighbours move against each other.\n    sway [m] = 0;\n    w [rad/s] = 4;\n    g [m/s^2] = 9.81;\n}\n\nbodies { platform: free, mass m, inertia [A, A, C]; }\nloads { gravity [0, 0, -g]; }\n\nfragment Leg(i, side) {\n    let foot_angle = i*120 [deg] + side*foot;\n    let head_angle = i*120 [deg] + side*(60 [deg] - head);\n    let on_ground = R*[cos(foot_angle), sin(foot_angle), 0];\n    let on_platform = on(platform, r*[cos(head_angle), sin(head_angle), 0]);\n    joints { leg: link on_platform to on_ground, length L + heave*sin(w*t) + side*sway*sin(w*t + i*120 [deg]); }\n    drawing { line on_ground, on_platform; }\n}\nuse Leg(0, 1) as a1;\nuse Leg(1, -1) as a2;\nuse Leg(1, 1) as b1;\nuse Leg(2, -1) as b2;\nuse Leg(2, 1) as c1;\nuse Leg(3, -1) as c2;\n\nkernels { }\n\ninitial { guess platform_z = 0.7; }\nevents { period: sin(w*t/2) = 0; }\n\noutputs {\n    /// height of the platform\n    height [m] = platform_z;\n    /// lean of the platform\n    lean = (attitude(platform)*[0, 0, 1]).z;\n    leg_forces \"Forces in the legs, positive in tension\" {\n        force1 [N] = reaction(a1_leg);\n        force2 [N] = reaction(a2_leg);\n    }\n}\n\ndrawing {\n    ground a1_on_ground, a2_on_ground, b1_on_ground, b2_on_ground, c1_on_ground, c2_on_ground;\n    curve a1_on_platform, a2_on_platform, b1_on_platform, b2_on_platform, c1_on_platform, c2_on_platform, a1_on_platform;\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "platform_x",
                    unit: "m",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_x_dot",
                    unit: "m/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_x_ddot",
                    unit: "m/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Free,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "platform_y",
                    unit: "m",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_y_dot",
                    unit: "m/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_y_ddot",
                    unit: "m/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Free,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "platform_z",
                    unit: "m",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_z_dot",
                    unit: "m/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_z_ddot",
                    unit: "m/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "platform_q0",
                    unit: "1",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_q0_dot",
                    unit: "1/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_q0_ddot",
                    unit: "1/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "platform_q1",
                    unit: "1",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_q1_dot",
                    unit: "1/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_q1_ddot",
                    unit: "1/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Free,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "platform_q2",
                    unit: "1",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_q2_dot",
                    unit: "1/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_q2_ddot",
                    unit: "1/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Free,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "platform_q3",
                    unit: "1",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_q3_dot",
                    unit: "1/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_q3_ddot",
                    unit: "1/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Free,
                speed_given: false,
            },
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "A",
                unit: "kg*m^2",
                factor: 1f64,
                docs: "Principal moments of inertia of the platform.",
            },
            sim_kernel::Quantity {
                name: "C",
                unit: "kg*m^2",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "R",
                unit: "m",
                factor: 1f64,
                docs: "Radius of the circle of the feet.",
            },
            sim_kernel::Quantity {
                name: "r",
                unit: "m",
                factor: 1f64,
                docs: "Radius of the circle of the heads.",
            },
            sim_kernel::Quantity {
                name: "foot",
                unit: "deg",
                factor: 0.017453292519943295f64,
                docs: "Half of the angle between the feet of a pair.",
            },
            sim_kernel::Quantity {
                name: "head",
                unit: "deg",
                factor: 0.017453292519943295f64,
                docs: "Half of the angle between the heads of a pair.",
            },
            sim_kernel::Quantity {
                name: "L",
                unit: "m",
                factor: 1f64,
                docs: "Length of the legs at rest.",
            },
            sim_kernel::Quantity {
                name: "heave",
                unit: "m",
                factor: 1f64,
                docs: "How far all legs move together.",
            },
            sim_kernel::Quantity {
                name: "sway",
                unit: "m",
                factor: 1f64,
                docs: "How far neighbours move against each other.",
            },
            sim_kernel::Quantity {
                name: "w",
                unit: "rad/s",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                docs: "",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "platform_norm",
                unit: "N*m",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "a1_leg",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "a2_leg",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "b1_leg",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "b2_leg",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "c1_leg",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "c2_leg",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
        ],
        speed_constraints: &[],
        norm_constraints: &[0],
        conditionals: &[],
        events: &[
            sim_kernel::event::Event {
                name: "period",
                direction: sim_kernel::event::Direction::Both,
                on_forces: false,
                steps: &[],
            },
        ],
        outputs: &[
            sim_kernel::Quantity {
                name: "height",
                unit: "m",
                factor: 1f64,
                docs: "height of the platform",
            },
            sim_kernel::Quantity {
                name: "lean",
                unit: "1",
                factor: 1f64,
                docs: "lean of the platform",
            },
            sim_kernel::Quantity {
                name: "force1",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "force2",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
        ],
        rated_outputs: &[0, 1],
        figures: &[
            sim_kernel::Figure {
                name: "height",
                title: "height of the platform",
                len: 1,
            },
            sim_kernel::Figure {
                name: "lean",
                title: "lean of the platform",
                len: 1,
            },
            sim_kernel::Figure {
                name: "leg_forces",
                title: "Forces in the legs, positive in tension",
                len: 2,
            },
        ],
        dimension: 3,
        drawing: &[
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Ground(6),
            sim_kernel::Shape::Curve(7),
        ],
    };
    fn defaults() -> Self {
        Self {
            m: S::from_f64(40f64),
            A: S::from_f64(3f64),
            C: S::from_f64(5f64),
            R: S::from_f64(0.9f64),
            r: S::from_f64(0.5f64),
            foot: S::from_f64(0.17453292519943295f64),
            head: S::from_f64(0.20943951023931953f64),
            L: S::from_f64(1f64),
            heave: S::from_f64(0.1f64),
            sway: S::from_f64(0f64),
            w: S::from_f64(4f64),
            g: S::from_f64(9.81f64),
        }
    }
    fn parameters(&self) -> [S; 12] {
        [
            self.m,
            self.A,
            self.C,
            self.R,
            self.r,
            self.foot,
            self.head,
            self.L,
            self.heave,
            self.sway,
            self.w,
            self.g,
        ]
    }
    fn with_parameters(&self, parameters: [S; 12]) -> Self {
        Self {
            m: parameters[0],
            A: parameters[1],
            C: parameters[2],
            R: parameters[3],
            r: parameters[4],
            foot: parameters[5],
            head: parameters[6],
            L: parameters[7],
            heave: parameters[8],
            sway: parameters[9],
            w: parameters[10],
            g: parameters[11],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Stewart<T> {
        Stewart {
            m: convert(self.m),
            A: convert(self.A),
            C: convert(self.C),
            R: convert(self.R),
            r: convert(self.r),
            foot: convert(self.foot),
            head: convert(self.head),
            L: convert(self.L),
            heave: convert(self.heave),
            sway: convert(self.sway),
            w: convert(self.w),
            g: convert(self.g),
        }
    }
    fn inputs(&self) -> [sim_kernel::Input<S>; 0] {
        []
    }
    fn with_inputs(&self, inputs: [sim_kernel::Input<S>; 0]) -> Self {
        Self { ..*self }
    }
    fn set_inputs(prepared: &mut Self::Prepared, inputs: [sim_kernel::Input<S>; 0]) {}
    #[inline(always)]
    fn prepare(&self) -> StewartPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::Dynamics<S, [S; 7], [S; 7]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn mass_matrix(&self, t: S, q: &[S; 7]) -> [[S; 7]; 7] {
        self.mass_matrix(t, q)
    }
    #[inline(always)]
    fn convective_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        self.convective_forces(t, q, qd)
    }
    #[inline(always)]
    fn generalized_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        self.generalized_forces(t, q, qd)
    }
    #[inline(always)]
    fn constraints(&self, t: S, q: &[S; 7]) -> [S; 7] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 7]) -> [S; 7] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 7]) -> [[S; 7]; 7] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 7]) -> [S; 7] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 7],
    ) -> sim_kernel::ConstraintLinearization<[S; 7], [[S; 7]; 7]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 7], qd: &[S; 7], qdd: &[S; 7], lambda: &[S; 7]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 7],
    ) -> [S; 4] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 7], qd: &[S; 7], qdd: &[S; 7]) -> [S; 2] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 7],
    ) -> [S; 1] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 7]) -> [S; 75] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 7]> {
        self.initial()
    }
}
