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
    /// Operations: 35 additions, 66 multiplications, 1 division.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        let [_, _, _, platform_q0, platform_q1, platform_q2, platform_q3] = *q;
        let [_, _, _, platform_q0_dot, platform_q1_dot, platform_q2_dot, platform_q3_dot,
        ] = *qd;
        let w = platform_q0 * platform_q3_dot - platform_q3 * platform_q0_dot
            - platform_q1 * platform_q2_dot + platform_q2 * platform_q1_dot;
        let w_2 = platform_q0 * platform_q0_dot + platform_q1 * platform_q1_dot
            + platform_q2 * platform_q2_dot + platform_q3 * platform_q3_dot;
        let w_3 = S::from_f64(1.0)
            / (platform_q0 * platform_q0 + platform_q1 * platform_q1
                + platform_q2 * platform_q2 + platform_q3 * platform_q3);
        let w_3_squared = w_3 * w_3;
        let w_4 = w * w_2 * w_3 * w_3_squared * S::from_f64(8.0) * self.C;
        let w_5 = platform_q0 * platform_q2_dot - platform_q2 * platform_q0_dot
            - platform_q3 * platform_q1_dot + platform_q1 * platform_q3_dot;
        let w_6 = platform_q0 * platform_q1_dot - platform_q1 * platform_q0_dot
            - platform_q2 * platform_q3_dot + platform_q3 * platform_q2_dot;
        let w_7 = self.A * w_2;
        let w_8 = w_3_squared * (w_5 * w * (self.C - self.A) - w_6 * w_7);
        let w_9 = w_3_squared * (w * w_6 * (self.A - self.C) - w_5 * w_7);
        let w_10 = (platform_q0_dot * platform_q0_dot + platform_q1_dot * platform_q1_dot
            + platform_q2_dot * platform_q2_dot + platform_q3_dot * platform_q3_dot)
            * S::from_f64(1.3333333333333333) * (self.A * S::from_f64(2.0) + self.C);
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            platform_q3 * w_4
                - S::from_f64(8.0) * w_3 * (platform_q1 * w_8 + platform_q2 * w_9)
                + platform_q0 * w_10,
            S::from_f64(8.0) * w_3 * (platform_q0 * w_8 - platform_q3 * w_9)
                - platform_q2 * w_4 + platform_q1 * w_10,
            S::from_f64(8.0) * w_3 * (platform_q3 * w_8 + platform_q0 * w_9)
                + platform_q1 * w_4 + platform_q2 * w_10,
            S::from_f64(8.0) * w_3 * (platform_q1 * w_9 - platform_q2 * w_8)
                - platform_q0 * w_4 + platform_q3 * w_10,
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
    /// Operations: 107 additions, 123 multiplications, 1 division, 16 sine-cosine pairs, 6 square roots.
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
        let w_11 = S::from_f64(2.0) * w_10;
        let w_12 = (platform_q2_squared + platform_q3_squared) * w_11 - S::from_f64(1.0);
        let w_13 = self.r * S::from_f64(2.0);
        let w_14 = sin_a1_head_angle * w_13;
        let w_15 = platform_q1 * platform_q2;
        let w_16 = platform_q0 * platform_q3;
        let w_17 = w_10 * (w_15 - w_16);
        let w_18 = platform_x - self.R * cos_foot - w_12 * self.r * cos_a1_head_angle
            + w_14 * w_17;
        let w_19 = cos_a1_head_angle * w_13;
        let w_20 = w_10 * (w_15 + w_16);
        let w_21 = w_11 * (platform_q1_squared + platform_q3_squared) - S::from_f64(1.0);
        let w_22 = platform_y - self.R * sin_foot + w_19 * w_20
            - w_21 * self.r * sin_a1_head_angle;
        let w_23 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_24 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let a1_on_platform_z = w_10 * (w_19 * w_23 + w_14 * w_24) + platform_z;
        let w_25 = w_13 * sin_a2_head_angle;
        let w_26 = platform_x - self.R * cos_a2_foot_angle
            - w_12 * self.r * cos_a2_head_angle + w_17 * w_25;
        let w_27 = w_13 * cos_a2_head_angle;
        let w_28 = platform_y - self.R * sin_a2_foot_angle + w_20 * w_27
            - w_21 * self.r * sin_a2_head_angle;
        let a2_on_platform_z = w_10 * (w_23 * w_27 + w_24 * w_25) + platform_z;
        let w_29 = self.heave * sin_w_2;
        let w_30 = self.sway * w_7;
        let w_31 = w_13 * sin_b1_head_angle;
        let w_32 = platform_x - self.R * cos_b1_foot_angle
            - w_12 * self.r * cos_b1_head_angle + w_17 * w_31;
        let w_33 = w_13 * cos_b1_head_angle;
        let w_34 = platform_y - self.R * sin_b1_foot_angle + w_20 * w_33
            - w_21 * self.r * sin_b1_head_angle;
        let b1_on_platform_z = w_10 * (w_23 * w_33 + w_24 * w_31) + platform_z;
        let w_35 = w_13 * sin_b2_head_angle;
        let w_36 = platform_x - self.R * cos_b2_foot_angle
            - w_12 * self.r * cos_b2_head_angle + w_17 * w_35;
        let w_37 = w_13 * cos_b2_head_angle;
        let w_38 = platform_y - self.R * sin_b2_foot_angle + w_20 * w_37
            - w_21 * self.r * sin_b2_head_angle;
        let b2_on_platform_z = w_10 * (w_23 * w_37 + w_24 * w_35) + platform_z;
        let w_39 = self.sway * w_8;
        let w_40 = w_13 * sin_c1_head_angle;
        let w_41 = platform_x - self.R * cos_c1_foot_angle
            - w_12 * self.r * cos_c1_head_angle + w_17 * w_40;
        let w_42 = w_13 * cos_c1_head_angle;
        let w_43 = platform_y - self.R * sin_c1_foot_angle + w_20 * w_42
            - w_21 * self.r * sin_c1_head_angle;
        let c1_on_platform_z = w_10 * (w_23 * w_42 + w_24 * w_40) + platform_z;
        let w_44 = w_13 * sin_c2_head_angle;
        let w_45 = platform_x - self.R * cos_c2_foot_angle
            - w_12 * self.r * cos_c2_head_angle + w_17 * w_44;
        let w_46 = w_13 * cos_c2_head_angle;
        let w_47 = platform_y - self.R * sin_c2_foot_angle + w_20 * w_46
            - w_21 * self.r * sin_c2_head_angle;
        let c2_on_platform_z = w_10 * (w_23 * w_46 + w_24 * w_44) + platform_z;
        [
            platform_q0_squared + platform_q1_squared + platform_q2_squared
                + platform_q3_squared - S::from_f64(1.0),
            (w_18 * w_18 + w_22 * w_22 + a1_on_platform_z * a1_on_platform_z).sqrt()
                - self.L - sin_w_2 * (self.heave + self.sway),
            (w_26 * w_26 + w_28 * w_28 + a2_on_platform_z * a2_on_platform_z).sqrt()
                - self.L - w_29 + w_30,
            (w_32 * w_32 + w_34 * w_34 + b1_on_platform_z * b1_on_platform_z).sqrt()
                - self.L - w_29 - w_30,
            (w_36 * w_36 + w_38 * w_38 + b2_on_platform_z * b2_on_platform_z).sqrt()
                - self.L - w_29 + w_39,
            (w_41 * w_41 + w_43 * w_43 + c1_on_platform_z * c1_on_platform_z).sqrt()
                - self.L - w_29 - w_39,
            (w_45 * w_45 + w_47 * w_47 + c2_on_platform_z * c2_on_platform_z).sqrt()
                - self.L - w_29 + self.sway * w_9,
        ]
    }
    /// The sum of the magnitudes of the terms of `C`, 7, in SI units: what its rounding is relative to.
    ///
    /// Operations: 123 additions, 123 multiplications, 1 division, 16 sine-cosine pairs, 6 square roots.
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
        let w_11 = S::from_f64(2.0) * w_10;
        let w_12 = (platform_q2_squared + platform_q3_squared) * w_11 - S::from_f64(1.0);
        let w_13 = self.r * S::from_f64(2.0);
        let w_14 = sin_a1_head_angle * w_13;
        let w_15 = platform_q1 * platform_q2;
        let w_16 = platform_q0 * platform_q3;
        let w_17 = w_10 * (w_15 - w_16);
        let w_18 = platform_x - self.R * cos_foot - w_12 * self.r * cos_a1_head_angle
            + w_14 * w_17;
        let w_19 = cos_a1_head_angle * w_13;
        let w_20 = w_10 * (w_15 + w_16);
        let w_21 = w_11 * (platform_q1_squared + platform_q3_squared) - S::from_f64(1.0);
        let w_22 = platform_y - self.R * sin_foot + w_19 * w_20
            - w_21 * self.r * sin_a1_head_angle;
        let w_23 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_24 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let a1_on_platform_z = w_10 * (w_19 * w_23 + w_14 * w_24) + platform_z;
        let w_25 = (self.heave * sin_w_2).abs();
        let w_26 = w_13 * sin_a2_head_angle;
        let w_27 = platform_x - self.R * cos_a2_foot_angle
            - w_12 * self.r * cos_a2_head_angle + w_17 * w_26;
        let w_28 = w_13 * cos_a2_head_angle;
        let w_29 = platform_y - self.R * sin_a2_foot_angle + w_20 * w_28
            - w_21 * self.r * sin_a2_head_angle;
        let a2_on_platform_z = w_10 * (w_23 * w_28 + w_24 * w_26) + platform_z;
        let w_30 = (self.sway * w_7).abs();
        let w_31 = w_13 * sin_b1_head_angle;
        let w_32 = platform_x - self.R * cos_b1_foot_angle
            - w_12 * self.r * cos_b1_head_angle + w_17 * w_31;
        let w_33 = w_13 * cos_b1_head_angle;
        let w_34 = platform_y - self.R * sin_b1_foot_angle + w_20 * w_33
            - w_21 * self.r * sin_b1_head_angle;
        let b1_on_platform_z = w_10 * (w_23 * w_33 + w_24 * w_31) + platform_z;
        let w_35 = w_13 * sin_b2_head_angle;
        let w_36 = platform_x - self.R * cos_b2_foot_angle
            - w_12 * self.r * cos_b2_head_angle + w_17 * w_35;
        let w_37 = w_13 * cos_b2_head_angle;
        let w_38 = platform_y - self.R * sin_b2_foot_angle + w_20 * w_37
            - w_21 * self.r * sin_b2_head_angle;
        let b2_on_platform_z = w_10 * (w_23 * w_37 + w_24 * w_35) + platform_z;
        let w_39 = (self.sway * w_8).abs();
        let w_40 = w_13 * sin_c1_head_angle;
        let w_41 = platform_x - self.R * cos_c1_foot_angle
            - w_12 * self.r * cos_c1_head_angle + w_17 * w_40;
        let w_42 = w_13 * cos_c1_head_angle;
        let w_43 = platform_y - self.R * sin_c1_foot_angle + w_20 * w_42
            - w_21 * self.r * sin_c1_head_angle;
        let c1_on_platform_z = w_10 * (w_23 * w_42 + w_24 * w_40) + platform_z;
        let w_44 = w_13 * sin_c2_head_angle;
        let w_45 = platform_x - self.R * cos_c2_foot_angle
            - w_12 * self.r * cos_c2_head_angle + w_17 * w_44;
        let w_46 = w_13 * cos_c2_head_angle;
        let w_47 = platform_y - self.R * sin_c2_foot_angle + w_20 * w_46
            - w_21 * self.r * sin_c2_head_angle;
        let c2_on_platform_z = w_10 * (w_23 * w_46 + w_24 * w_44) + platform_z;
        [
            platform_q0_squared.abs() + platform_q1_squared.abs()
                + platform_q2_squared.abs() + platform_q3_squared.abs()
                + S::from_f64(1.0),
            abs_L
                + (w_18 * w_18 + w_22 * w_22 + a1_on_platform_z * a1_on_platform_z)
                    .sqrt()
                    .abs() + w_25 + (sin_w_2 * self.sway).abs(),
            abs_L + w_25
                + (w_27 * w_27 + w_29 * w_29 + a2_on_platform_z * a2_on_platform_z)
                    .sqrt()
                    .abs() + w_30,
            abs_L + w_25 + w_30
                + (w_32 * w_32 + w_34 * w_34 + b1_on_platform_z * b1_on_platform_z)
                    .sqrt()
                    .abs(),
            abs_L + w_25
                + (w_36 * w_36 + w_38 * w_38 + b2_on_platform_z * b2_on_platform_z)
                    .sqrt()
                    .abs() + w_39,
            abs_L + w_25 + w_39
                + (w_41 * w_41 + w_43 * w_43 + c1_on_platform_z * c1_on_platform_z)
                    .sqrt()
                    .abs(),
            abs_L + w_25
                + (w_45 * w_45 + w_47 * w_47 + c2_on_platform_z * c2_on_platform_z)
                    .sqrt()
                    .abs() + (self.sway * w_9).abs(),
        ]
    }
    /// Constraint Jacobian `C_q`, 7 x 7: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 270 additions, 517 multiplications, 43 divisions, 12 sine-cosine pairs, 6 square roots.
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
        let platform_q2_squared = platform_q2 * platform_q2;
        let platform_q3_squared = platform_q3 * platform_q3;
        let w_5 = platform_q2_squared + platform_q3_squared;
        let platform_q1_squared = platform_q1 * platform_q1;
        let w_6 = S::from_f64(1.0)
            / (platform_q0 * platform_q0 + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_7 = w_6 * S::from_f64(2.0);
        let w_8 = w_5 * w_7 - S::from_f64(1.0);
        let w_9 = self.r * cos_a1_head_angle;
        let w_10 = S::from_f64(2.0) * self.r;
        let w_11 = sin_a1_head_angle * w_10;
        let w_12 = platform_q1 * platform_q2;
        let w_13 = platform_q0 * platform_q3;
        let w_14 = w_12 - w_13;
        let w_15 = w_6 * w_14;
        let w_16 = platform_x - self.R * cos_foot - w_8 * w_9 + w_11 * w_15;
        let w_17 = cos_a1_head_angle * w_10;
        let w_18 = w_12 + w_13;
        let w_19 = w_6 * w_18;
        let w_20 = platform_q1_squared + platform_q3_squared;
        let w_21 = w_7 * w_20 - S::from_f64(1.0);
        let w_22 = self.r * sin_a1_head_angle;
        let w_23 = platform_y - self.R * sin_foot + w_17 * w_19 - w_21 * w_22;
        let w_24 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_25 = platform_q2 * platform_q3 + platform_q1 * platform_q0;
        let w_26 = w_17 * w_24 + w_11 * w_25;
        let a1_on_platform_z = w_6 * w_26 + platform_z;
        let w_27 = w_16 * w_16 + w_23 * w_23 + a1_on_platform_z * a1_on_platform_z;
        let sqrt_w_27 = w_27.sqrt();
        let w_6_squared = w_6 * w_6;
        let w_28 = w_6_squared * (w_5 * w_17 - w_14 * w_11);
        let w_29 = platform_q3 * w_6;
        let w_30 = w_6_squared * (w_11 * w_20 - w_18 * w_17);
        let w_31 = w_6_squared * w_26;
        let w_32 = a1_on_platform_z
            * (platform_q0 * w_31 + w_6 * (platform_q2 * w_9 - platform_q1 * w_22));
        let w_33 = S::from_f64(2.0) * sqrt_w_27;
        let w_34 = platform_q2 * w_6;
        let w_35 = w_18 * platform_q1 * w_6_squared;
        let w_36 = w_6 - w_6_squared * w_20;
        let w_37 = platform_q1 * w_36;
        let w_38 = a1_on_platform_z
            * (w_6 * (platform_q3 * w_9 + platform_q0 * w_22) - platform_q1 * w_31);
        let w_39 = platform_q1 * w_6;
        let w_40 = w_6 - w_6_squared * w_5;
        let w_41 = platform_q2 * w_40;
        let w_42 = w_14 * platform_q2 * w_6_squared;
        let w_43 = a1_on_platform_z
            * (w_6 * (platform_q3 * w_22 - platform_q0 * w_9) - platform_q2 * w_31);
        let w_44 = platform_q0 * w_6;
        let w_45 = platform_q3 * w_40;
        let w_46 = platform_q3 * w_6_squared;
        let w_47 = w_14 * w_46;
        let w_48 = w_18 * w_46;
        let w_49 = platform_q3 * w_36;
        let w_50 = a1_on_platform_z
            * (w_6 * (platform_q2 * w_22 + platform_q1 * w_9) - platform_q3 * w_31);
        let w_51 = w_33
            * (w_16 * (w_22 * w_44 + w_17 * w_45 + w_11 * w_47)
                - w_23 * (w_9 * w_44 - w_17 * w_48 - w_11 * w_49) - w_50);
        let w_52 = self.r * cos_a2_head_angle;
        let w_53 = w_10 * sin_a2_head_angle;
        let w_54 = platform_x - self.R * cos_a2_foot_angle - w_8 * w_52 + w_15 * w_53;
        let w_55 = w_10 * cos_a2_head_angle;
        let w_56 = self.r * sin_a2_head_angle;
        let w_57 = platform_y - self.R * sin_a2_foot_angle + w_19 * w_55 - w_21 * w_56;
        let w_58 = w_24 * w_55 + w_25 * w_53;
        let a2_on_platform_z = w_6 * w_58 + platform_z;
        let w_59 = w_54 * w_54 + w_57 * w_57 + a2_on_platform_z * a2_on_platform_z;
        let sqrt_w_59 = w_59.sqrt();
        let w_60 = w_6_squared * (w_5 * w_55 - w_14 * w_53);
        let w_61 = w_6_squared * (w_20 * w_53 - w_18 * w_55);
        let w_62 = w_6_squared * w_58;
        let w_63 = a2_on_platform_z
            * (platform_q0 * w_62 + w_6 * (platform_q2 * w_52 - platform_q1 * w_56));
        let w_64 = S::from_f64(2.0) * sqrt_w_59;
        let w_65 = a2_on_platform_z
            * (w_6 * (platform_q3 * w_52 + platform_q0 * w_56) - platform_q1 * w_62);
        let w_66 = a2_on_platform_z
            * (w_6 * (platform_q3 * w_56 - platform_q0 * w_52) - platform_q2 * w_62);
        let w_67 = a2_on_platform_z
            * (w_6 * (platform_q2 * w_56 + platform_q1 * w_52) - platform_q3 * w_62);
        let w_68 = w_64
            * (w_54 * (w_44 * w_56 + w_45 * w_55 + w_47 * w_53)
                - w_57 * (w_44 * w_52 - w_48 * w_55 - w_49 * w_53) - w_67);
        let w_69 = self.r * cos_b1_head_angle;
        let w_70 = w_10 * sin_b1_head_angle;
        let w_71 = platform_x - self.R * cos_b1_foot_angle - w_8 * w_69 + w_15 * w_70;
        let w_72 = w_10 * cos_b1_head_angle;
        let w_73 = self.r * sin_b1_head_angle;
        let w_74 = platform_y - self.R * sin_b1_foot_angle + w_19 * w_72 - w_21 * w_73;
        let w_75 = w_24 * w_72 + w_25 * w_70;
        let b1_on_platform_z = w_6 * w_75 + platform_z;
        let w_76 = w_71 * w_71 + w_74 * w_74 + b1_on_platform_z * b1_on_platform_z;
        let sqrt_w_76 = w_76.sqrt();
        let w_77 = w_6_squared * (w_5 * w_72 - w_14 * w_70);
        let w_78 = w_6_squared * (w_20 * w_70 - w_18 * w_72);
        let w_79 = w_6_squared * w_75;
        let w_80 = b1_on_platform_z
            * (platform_q0 * w_79 + w_6 * (platform_q2 * w_69 - platform_q1 * w_73));
        let w_81 = S::from_f64(2.0) * sqrt_w_76;
        let w_82 = b1_on_platform_z
            * (w_6 * (platform_q3 * w_69 + platform_q0 * w_73) - platform_q1 * w_79);
        let w_83 = b1_on_platform_z
            * (w_6 * (platform_q3 * w_73 - platform_q0 * w_69) - platform_q2 * w_79);
        let w_84 = b1_on_platform_z
            * (w_6 * (platform_q2 * w_73 + platform_q1 * w_69) - platform_q3 * w_79);
        let w_85 = w_81
            * (w_71 * (w_44 * w_73 + w_45 * w_72 + w_47 * w_70)
                - w_74 * (w_44 * w_69 - w_48 * w_72 - w_49 * w_70) - w_84);
        let w_86 = self.r * cos_b2_head_angle;
        let w_87 = w_10 * sin_b2_head_angle;
        let w_88 = platform_x - self.R * cos_b2_foot_angle - w_8 * w_86 + w_15 * w_87;
        let w_89 = w_10 * cos_b2_head_angle;
        let w_90 = self.r * sin_b2_head_angle;
        let w_91 = platform_y - self.R * sin_b2_foot_angle + w_19 * w_89 - w_21 * w_90;
        let w_92 = w_24 * w_89 + w_25 * w_87;
        let b2_on_platform_z = w_6 * w_92 + platform_z;
        let w_93 = w_88 * w_88 + w_91 * w_91 + b2_on_platform_z * b2_on_platform_z;
        let sqrt_w_93 = w_93.sqrt();
        let w_94 = w_6_squared * (w_5 * w_89 - w_14 * w_87);
        let w_95 = w_6_squared * (w_20 * w_87 - w_18 * w_89);
        let w_96 = w_6_squared * w_92;
        let w_97 = b2_on_platform_z
            * (platform_q0 * w_96 + w_6 * (platform_q2 * w_86 - platform_q1 * w_90));
        let w_98 = S::from_f64(2.0) * sqrt_w_93;
        let w_99 = b2_on_platform_z
            * (w_6 * (platform_q3 * w_86 + platform_q0 * w_90) - platform_q1 * w_96);
        let w_100 = b2_on_platform_z
            * (w_6 * (platform_q3 * w_90 - platform_q0 * w_86) - platform_q2 * w_96);
        let w_101 = b2_on_platform_z
            * (w_6 * (platform_q2 * w_90 + platform_q1 * w_86) - platform_q3 * w_96);
        let w_102 = w_98
            * (w_88 * (w_44 * w_90 + w_45 * w_89 + w_47 * w_87)
                - w_91 * (w_44 * w_86 - w_48 * w_89 - w_49 * w_87) - w_101);
        let w_103 = self.r * cos_c1_head_angle;
        let w_104 = w_10 * sin_c1_head_angle;
        let w_105 = platform_x - self.R * cos_c1_foot_angle - w_8 * w_103 + w_15 * w_104;
        let w_106 = w_10 * cos_c1_head_angle;
        let w_107 = self.r * sin_c1_head_angle;
        let w_108 = platform_y - self.R * sin_c1_foot_angle + w_19 * w_106
            - w_21 * w_107;
        let w_109 = w_24 * w_106 + w_25 * w_104;
        let c1_on_platform_z = w_6 * w_109 + platform_z;
        let w_110 = w_105 * w_105 + w_108 * w_108 + c1_on_platform_z * c1_on_platform_z;
        let sqrt_w_110 = w_110.sqrt();
        let w_111 = w_6_squared * (w_5 * w_106 - w_14 * w_104);
        let w_112 = w_6_squared * (w_20 * w_104 - w_18 * w_106);
        let w_113 = w_6_squared * w_109;
        let w_114 = c1_on_platform_z
            * (platform_q0 * w_113 + w_6 * (platform_q2 * w_103 - platform_q1 * w_107));
        let w_115 = S::from_f64(2.0) * sqrt_w_110;
        let w_116 = c1_on_platform_z
            * (w_6 * (platform_q3 * w_103 + platform_q0 * w_107) - platform_q1 * w_113);
        let w_117 = c1_on_platform_z
            * (w_6 * (platform_q3 * w_107 - platform_q0 * w_103) - platform_q2 * w_113);
        let w_118 = c1_on_platform_z
            * (w_6 * (platform_q2 * w_107 + platform_q1 * w_103) - platform_q3 * w_113);
        let w_119 = w_115
            * (w_105 * (w_44 * w_107 + w_45 * w_106 + w_47 * w_104)
                - w_108 * (w_44 * w_103 - w_48 * w_106 - w_49 * w_104) - w_118);
        let w_120 = self.r * cos_c2_head_angle;
        let w_121 = w_10 * sin_c2_head_angle;
        let w_122 = platform_x - self.R * cos_c2_foot_angle - w_8 * w_120 + w_15 * w_121;
        let w_123 = w_10 * cos_c2_head_angle;
        let w_124 = self.r * sin_c2_head_angle;
        let w_125 = platform_y - self.R * sin_c2_foot_angle + w_19 * w_123
            - w_21 * w_124;
        let w_126 = w_24 * w_123 + w_25 * w_121;
        let c2_on_platform_z = w_6 * w_126 + platform_z;
        let w_127 = w_122 * w_122 + w_125 * w_125 + c2_on_platform_z * c2_on_platform_z;
        let sqrt_w_127 = w_127.sqrt();
        let w_128 = w_6_squared * (w_5 * w_123 - w_14 * w_121);
        let w_129 = w_6_squared * (w_20 * w_121 - w_18 * w_123);
        let w_130 = w_6_squared * w_126;
        let w_131 = c2_on_platform_z
            * (platform_q0 * w_130 + w_6 * (platform_q2 * w_120 - platform_q1 * w_124));
        let w_132 = S::from_f64(2.0) * sqrt_w_127;
        let w_133 = c2_on_platform_z
            * (w_6 * (platform_q3 * w_120 + platform_q0 * w_124) - platform_q1 * w_130);
        let w_134 = c2_on_platform_z
            * (w_6 * (platform_q3 * w_124 - platform_q0 * w_120) - platform_q2 * w_130);
        let w_135 = c2_on_platform_z
            * (w_6 * (platform_q2 * w_124 + platform_q1 * w_120) - platform_q3 * w_130);
        let w_136 = w_132
            * (w_122 * (w_44 * w_124 + w_45 * w_123 + w_47 * w_121)
                - w_125 * (w_44 * w_120 - w_48 * w_123 - w_49 * w_121) - w_135);
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
                w_16 * sqrt_w_27 / w_27,
                w_23 * sqrt_w_27 / w_27,
                a1_on_platform_z * sqrt_w_27 / w_27,
                (w_16 * (platform_q0 * w_28 - w_22 * w_29)
                    + w_23 * (platform_q0 * w_30 + w_9 * w_29) - w_32) * w_33 / w_27,
                w_33
                    * (w_16 * (platform_q1 * w_28 + w_22 * w_34)
                        + w_23 * (w_9 * w_34 - w_17 * w_35 - w_11 * w_37) + w_38) / w_27,
                w_33
                    * (w_16 * (w_22 * w_39 - w_17 * w_41 - w_11 * w_42)
                        + w_23 * (platform_q2 * w_30 + w_9 * w_39) + w_43) / w_27,
                -(w_51 / w_27),
            ],
            [
                w_54 * sqrt_w_59 / w_59,
                w_57 * sqrt_w_59 / w_59,
                a2_on_platform_z * sqrt_w_59 / w_59,
                (w_54 * (platform_q0 * w_60 - w_29 * w_56)
                    + w_57 * (platform_q0 * w_61 + w_29 * w_52) - w_63) * w_64 / w_59,
                w_64
                    * (w_54 * (platform_q1 * w_60 + w_34 * w_56)
                        + w_57 * (w_34 * w_52 - w_35 * w_55 - w_37 * w_53) + w_65)
                    / w_59,
                w_64
                    * (w_54 * (w_39 * w_56 - w_41 * w_55 - w_42 * w_53)
                        + w_57 * (platform_q2 * w_61 + w_39 * w_52) + w_66) / w_59,
                -(w_68 / w_59),
            ],
            [
                w_71 * sqrt_w_76 / w_76,
                w_74 * sqrt_w_76 / w_76,
                b1_on_platform_z * sqrt_w_76 / w_76,
                (w_71 * (platform_q0 * w_77 - w_29 * w_73)
                    + w_74 * (platform_q0 * w_78 + w_29 * w_69) - w_80) * w_81 / w_76,
                w_81
                    * (w_71 * (platform_q1 * w_77 + w_34 * w_73)
                        + w_74 * (w_34 * w_69 - w_35 * w_72 - w_37 * w_70) + w_82)
                    / w_76,
                w_81
                    * (w_71 * (w_39 * w_73 - w_41 * w_72 - w_42 * w_70)
                        + w_74 * (platform_q2 * w_78 + w_39 * w_69) + w_83) / w_76,
                -(w_85 / w_76),
            ],
            [
                w_88 * sqrt_w_93 / w_93,
                w_91 * sqrt_w_93 / w_93,
                b2_on_platform_z * sqrt_w_93 / w_93,
                (w_88 * (platform_q0 * w_94 - w_29 * w_90)
                    + w_91 * (platform_q0 * w_95 + w_29 * w_86) - w_97) * w_98 / w_93,
                w_98
                    * (w_88 * (platform_q1 * w_94 + w_34 * w_90)
                        + w_91 * (w_34 * w_86 - w_35 * w_89 - w_37 * w_87) + w_99)
                    / w_93,
                w_98
                    * (w_88 * (w_39 * w_90 - w_41 * w_89 - w_42 * w_87)
                        + w_91 * (platform_q2 * w_95 + w_39 * w_86) + w_100) / w_93,
                -(w_102 / w_93),
            ],
            [
                w_105 * sqrt_w_110 / w_110,
                w_108 * sqrt_w_110 / w_110,
                c1_on_platform_z * sqrt_w_110 / w_110,
                (w_105 * (platform_q0 * w_111 - w_29 * w_107)
                    + w_108 * (platform_q0 * w_112 + w_29 * w_103) - w_114) * w_115
                    / w_110,
                w_115
                    * (w_105 * (platform_q1 * w_111 + w_34 * w_107)
                        + w_108 * (w_34 * w_103 - w_35 * w_106 - w_37 * w_104) + w_116)
                    / w_110,
                w_115
                    * (w_105 * (w_39 * w_107 - w_41 * w_106 - w_42 * w_104)
                        + w_108 * (platform_q2 * w_112 + w_39 * w_103) + w_117) / w_110,
                -(w_119 / w_110),
            ],
            [
                w_122 * sqrt_w_127 / w_127,
                w_125 * sqrt_w_127 / w_127,
                c2_on_platform_z * sqrt_w_127 / w_127,
                (w_122 * (platform_q0 * w_128 - w_29 * w_124)
                    + w_125 * (platform_q0 * w_129 + w_29 * w_120) - w_131) * w_132
                    / w_127,
                w_132
                    * (w_122 * (platform_q1 * w_128 + w_34 * w_124)
                        + w_125 * (w_34 * w_120 - w_35 * w_123 - w_37 * w_121) + w_133)
                    / w_127,
                w_132
                    * (w_122 * (w_39 * w_124 - w_41 * w_123 - w_42 * w_121)
                        + w_125 * (platform_q2 * w_129 + w_39 * w_120) + w_134) / w_127,
                -(w_136 / w_127),
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
    /// Operations: 893 additions, 1438 multiplications, 25 divisions, 16 sine-cosine pairs, 6 square roots.
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
        let platform_q2_squared = platform_q2 * platform_q2;
        let platform_q3_squared = platform_q3 * platform_q3;
        let w_10 = platform_q2_squared + platform_q3_squared;
        let platform_q1_squared = platform_q1 * platform_q1;
        let w_11 = S::from_f64(1.0)
            / (platform_q0 * platform_q0 + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_12 = S::from_f64(2.0) * w_11;
        let w_13 = w_10 * w_12 - S::from_f64(1.0);
        let w_14 = self.r * cos_a1_head_angle;
        let w_15 = S::from_f64(2.0) * self.r;
        let w_16 = sin_a1_head_angle * w_15;
        let w_17 = platform_q1 * platform_q2;
        let w_18 = platform_q0 * platform_q3;
        let w_19 = w_17 - w_18;
        let w_20 = w_11 * w_19;
        let w_21 = platform_x - self.R * cos_foot - w_13 * w_14 + w_16 * w_20;
        let w_22 = cos_a1_head_angle * w_15;
        let w_23 = w_17 + w_18;
        let w_24 = w_11 * w_23;
        let w_25 = platform_q1_squared + platform_q3_squared;
        let w_26 = w_12 * w_25 - S::from_f64(1.0);
        let w_27 = self.r * sin_a1_head_angle;
        let w_28 = platform_y - self.R * sin_foot + w_22 * w_24 - w_26 * w_27;
        let w_29 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_30 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let w_31 = w_22 * w_29 + w_16 * w_30;
        let a1_on_platform_z = w_11 * w_31 + platform_z;
        let w_32 = w_21 * w_21 + w_28 * w_28 + a1_on_platform_z * a1_on_platform_z;
        let w_33 = platform_q1_dot * platform_q1;
        let w_34 = platform_q2_dot * platform_q2;
        let w_35 = platform_q3_dot * platform_q3;
        let w_36 = platform_q0_dot * platform_q0 + w_33 + w_34 + w_35;
        let w_11_squared = w_11 * w_11;
        let w_37 = w_10 * w_11_squared;
        let w_38 = w_34 + w_35;
        let w_39 = w_36 * w_37 - w_11 * w_38;
        let w_40 = self.r * S::from_f64(4.0);
        let w_41 = cos_a1_head_angle * w_40;
        let w_42 = sin_a1_head_angle * w_40;
        let w_43 = w_19 * w_11_squared;
        let w_44 = w_36 * w_43;
        let w_45 = platform_q3_dot * platform_q0;
        let w_46 = platform_q0_dot * platform_q3;
        let w_47 = platform_q2_dot * platform_q1;
        let w_48 = platform_q1_dot * platform_q2;
        let w_49 = w_45 + w_46 - w_47 - w_48;
        let w_50 = w_11 * w_49;
        let w_51 = platform_x_dot + w_39 * w_41 - w_42 * w_44 - w_16 * w_50;
        let w_52 = w_45 + w_46 + w_47 + w_48;
        let w_53 = w_11 * w_52;
        let w_54 = w_23 * w_11_squared;
        let w_55 = w_36 * w_54;
        let w_56 = w_25 * w_11_squared;
        let w_57 = w_33 + w_35;
        let w_58 = w_36 * w_56 - w_11 * w_57;
        let w_59 = platform_y_dot + w_22 * w_53 - w_41 * w_55 + w_42 * w_58;
        let w_60 = platform_q1_dot * platform_q0 + platform_q0_dot * platform_q1
            + platform_q3_dot * platform_q2 + platform_q2_dot * platform_q3;
        let w_61 = platform_q2_dot * platform_q0 + platform_q0_dot * platform_q2
            - platform_q1_dot * platform_q3 - platform_q3_dot * platform_q1;
        let w_62 = w_11 * (w_16 * w_60 - w_22 * w_61)
            - w_11_squared * w_36 * (w_29 * w_41 + w_30 * w_42) + platform_z_dot;
        let w_63 = w_21 * w_51 + w_28 * w_59 + a1_on_platform_z * w_62;
        let w_64 = platform_q0 * w_11;
        let w_65 = w_11 - w_37;
        let w_66 = platform_q3 * w_65;
        let w_67 = platform_q3 * w_43;
        let w_68 = w_27 * w_64 + w_22 * w_66 + w_16 * w_67;
        let w_69 = platform_q3 * w_54;
        let w_70 = w_11 - w_56;
        let w_71 = platform_q3 * w_70;
        let w_72 = w_14 * w_64 - w_22 * w_69 - w_16 * w_71;
        let w_73 = w_31 * w_11_squared;
        let w_74 = w_11 * (platform_q2 * w_27 + platform_q1 * w_14) - platform_q3 * w_73;
        let w_75 = w_11_squared * (w_10 * w_22 - w_19 * w_16);
        let w_76 = platform_q3 * w_11;
        let w_77 = platform_q0 * w_75 - w_27 * w_76;
        let w_78 = w_11_squared * (w_16 * w_25 - w_23 * w_22);
        let w_79 = platform_q0 * w_78 + w_14 * w_76;
        let w_80 = platform_q0 * w_73 + w_11 * (platform_q2 * w_14 - platform_q1 * w_27);
        let w_81 = platform_q2 * w_11;
        let w_82 = platform_q1 * w_75 + w_27 * w_81;
        let w_83 = platform_q1 * w_54;
        let w_84 = platform_q1 * w_70;
        let w_85 = w_14 * w_81 - w_22 * w_83 - w_16 * w_84;
        let w_86 = w_11 * (platform_q3 * w_14 + platform_q0 * w_27) - platform_q1 * w_73;
        let w_87 = platform_q1_dot
            * (w_21 * w_82 + w_28 * w_85 + a1_on_platform_z * w_86);
        let w_88 = platform_q1 * w_11;
        let w_89 = platform_q2 * w_65;
        let w_90 = platform_q2 * w_43;
        let w_91 = w_27 * w_88 - w_22 * w_89 - w_16 * w_90;
        let w_92 = platform_q2 * w_78 + w_14 * w_88;
        let w_93 = w_11 * (platform_q3 * w_27 - platform_q0 * w_14) - platform_q2 * w_73;
        let w_94 = platform_q2_dot
            * (w_21 * w_91 + w_28 * w_92 + a1_on_platform_z * w_93);
        let w_95 = platform_q3_dot
            * (w_21 * w_68 - w_28 * w_72 - a1_on_platform_z * w_74)
            - platform_q0_dot * (w_21 * w_77 + w_28 * w_79 - a1_on_platform_z * w_80)
            - w_87 - w_94;
        let w_32_squared = w_32 * w_32;
        let w_96 = platform_q3 * w_36;
        let w_97 = platform_q0 * w_49 - platform_q0_dot * w_19 + w_96;
        let w_98 = platform_q0_dot * w_10;
        let w_99 = platform_q0 * w_38;
        let w_100 = w_11 * w_11_squared;
        let w_101 = self.r * S::from_f64(8.0);
        let w_102 = sin_a1_head_angle * w_101;
        let w_103 = cos_a1_head_angle * w_101;
        let w_104 = w_36 * w_100 * (w_19 * w_102 - w_10 * w_103);
        let w_105 = platform_q3_dot * w_11;
        let w_106 = platform_q0_dot * w_25;
        let w_107 = w_96 + platform_q0_dot * w_23 + platform_q0 * w_52;
        let w_108 = platform_q0 * w_57;
        let w_109 = w_36 * w_100 * (w_23 * w_103 - w_25 * w_102);
        let w_110 = w_28
            * (w_11_squared * (w_16 * w_106 - w_22 * w_107 + w_42 * w_108)
                + platform_q0 * w_109 + w_14 * w_105);
        let w_111 = platform_q2 * w_36;
        let w_112 = platform_q0_dot * w_29 - platform_q0 * w_61 - w_111;
        let w_113 = platform_q1 * w_36;
        let w_114 = w_113 + platform_q0_dot * w_30 + platform_q0 * w_60;
        let w_115 = w_36 * w_100 * (w_29 * w_103 + w_30 * w_102);
        let w_116 = a1_on_platform_z
            * (w_11_squared * (w_22 * w_112 + w_16 * w_114) - platform_q0 * w_115
                + w_11 * (platform_q2_dot * w_14 - platform_q1_dot * w_27));
        let w_117 = w_51 * w_77
            + w_21
                * (w_11_squared * (w_16 * w_97 + w_22 * w_98 + w_41 * w_99)
                    + platform_q0 * w_104 - w_27 * w_105) + w_59 * w_79 + w_110
            - w_62 * w_80 - w_116;
        let w_118 = platform_q1 * w_49 - w_111 - platform_q1_dot * w_19;
        let w_119 = platform_q1_dot * w_10;
        let w_120 = platform_q1 * w_38;
        let w_121 = platform_q2_dot * w_11;
        let w_122 = w_21
            * (w_11_squared * (w_16 * w_118 + w_22 * w_119 + w_41 * w_120)
                + platform_q1 * w_104 + w_27 * w_121);
        let w_123 = w_11_squared * (w_111 + platform_q1_dot * w_23 + platform_q1 * w_52);
        let w_124 = w_36 * w_100;
        let w_125 = w_124 * platform_q1 * w_23;
        let w_126 = S::from_f64(4.0) * w_124;
        let w_127 = w_25 * w_126 - S::from_f64(2.0) * w_11_squared * (w_36 + w_57);
        let w_128 = platform_q1 * w_127 + platform_q1_dot * w_70;
        let w_129 = platform_q1 * w_61 - w_96 - platform_q1_dot * w_29;
        let w_130 = platform_q0 * w_36;
        let w_131 = w_130 + platform_q1_dot * w_30 + platform_q1 * w_60;
        let w_132 = a1_on_platform_z
            * (w_11_squared * (w_22 * w_129 - w_16 * w_131)
                + w_11 * (platform_q3_dot * w_14 + platform_q0_dot * w_27)
                + platform_q1 * w_115);
        let w_133 = w_51 * w_82 + w_122 + w_59 * w_85
            + w_28 * (w_14 * w_121 - w_22 * w_123 + w_103 * w_125 - w_16 * w_128)
            + w_62 * w_86 + w_132;
        let w_134 = w_11_squared * (platform_q2 * w_49 - w_113 - platform_q2_dot * w_19);
        let w_135 = platform_q1_dot * w_11;
        let w_136 = w_10 * w_126 - S::from_f64(2.0) * w_11_squared * (w_36 + w_38);
        let w_137 = platform_q2 * w_136 + platform_q2_dot * w_65;
        let w_138 = w_124 * platform_q2 * w_19;
        let w_139 = platform_q2_dot * w_25;
        let w_140 = w_113 + platform_q2_dot * w_23 + platform_q2 * w_52;
        let w_141 = platform_q2 * w_57;
        let w_142 = w_28
            * (w_11_squared * (w_16 * w_139 - w_22 * w_140 + w_42 * w_141)
                + platform_q2 * w_109 + w_14 * w_135);
        let w_143 = platform_q2 * w_61 - platform_q2_dot * w_29 + w_130;
        let w_144 = w_96 + platform_q2_dot * w_30 + platform_q2 * w_60;
        let w_145 = a1_on_platform_z
            * (w_11_squared * (w_22 * w_143 - w_16 * w_144)
                + w_11 * (platform_q3_dot * w_27 - platform_q0_dot * w_14)
                + platform_q2 * w_115);
        let w_146 = w_51 * w_91
            + w_21 * (w_16 * w_134 + w_27 * w_135 - w_22 * w_137 + w_102 * w_138)
            + w_59 * w_92 + w_142 + w_62 * w_93 + w_145;
        let w_147 = w_11_squared * (platform_q3_dot * w_19 - w_130 - platform_q3 * w_49);
        let w_148 = platform_q0_dot * w_11;
        let w_149 = platform_q3 * w_136 + platform_q3_dot * w_65;
        let w_150 = platform_q3 * w_124;
        let w_151 = w_19 * w_150;
        let w_152 = w_11_squared * (w_130 + platform_q3_dot * w_23 + platform_q3 * w_52);
        let w_153 = w_23 * w_150;
        let w_154 = platform_q3 * w_127 + platform_q3_dot * w_70;
        let w_155 = w_28 * (w_14 * w_148 - w_22 * w_152 + w_103 * w_153 - w_16 * w_154);
        let w_156 = platform_q3 * w_61 - w_113 - platform_q3_dot * w_29;
        let w_157 = w_111 + platform_q3_dot * w_30 + platform_q3 * w_60;
        let w_158 = a1_on_platform_z
            * (w_11_squared * (w_22 * w_156 - w_16 * w_157)
                + w_11 * (platform_q2_dot * w_27 + platform_q1_dot * w_14)
                + platform_q3 * w_115);
        let w_159 = w_51 * w_68
            + w_21 * (w_16 * w_147 + w_27 * w_148 + w_22 * w_149 - w_102 * w_151)
            - w_59 * w_72 - w_155 - w_62 * w_74 - w_158;
        let w_160 = S::from_f64(2.0)
            * (w_63 * (w_95 / w_32_squared)
                + (platform_q0_dot * w_117 + platform_q1_dot * w_133
                    + platform_q2_dot * w_146 - platform_q3_dot * w_159) / w_32);
        let w_161 = w_160
            + (platform_x_dot * w_51 + platform_y_dot * w_59 + platform_z_dot * w_62)
                / w_32
            - w_63
                * ((platform_x_dot * w_21 + w_28 * platform_y_dot
                    + a1_on_platform_z * platform_z_dot) / w_32_squared);
        let w_squared = self.w * self.w;
        let w_162 = self.heave * w_squared;
        let w_163 = w_squared * self.sway;
        let w_164 = self.r * cos_a2_head_angle;
        let w_165 = w_15 * sin_a2_head_angle;
        let w_166 = platform_x - self.R * cos_a2_foot_angle - w_13 * w_164
            + w_20 * w_165;
        let w_167 = w_15 * cos_a2_head_angle;
        let w_168 = self.r * sin_a2_head_angle;
        let w_169 = platform_y - self.R * sin_a2_foot_angle + w_24 * w_167
            - w_26 * w_168;
        let w_170 = w_29 * w_167 + w_30 * w_165;
        let a2_on_platform_z = w_11 * w_170 + platform_z;
        let w_171 = w_166 * w_166 + w_169 * w_169 + a2_on_platform_z * a2_on_platform_z;
        let w_172 = w_40 * cos_a2_head_angle;
        let w_173 = w_40 * sin_a2_head_angle;
        let w_174 = platform_x_dot + w_39 * w_172 - w_44 * w_173 - w_50 * w_165;
        let w_175 = platform_y_dot + w_53 * w_167 - w_55 * w_172 + w_58 * w_173;
        let w_176 = w_11 * (w_60 * w_165 - w_61 * w_167)
            - w_11_squared * w_36 * (w_29 * w_172 + w_30 * w_173) + platform_z_dot;
        let w_177 = w_166 * w_174 + w_169 * w_175 + a2_on_platform_z * w_176;
        let w_178 = w_64 * w_168 + w_66 * w_167 + w_67 * w_165;
        let w_179 = w_64 * w_164 - w_69 * w_167 - w_71 * w_165;
        let w_180 = w_11_squared * w_170;
        let w_181 = w_11 * (platform_q2 * w_168 + platform_q1 * w_164)
            - platform_q3 * w_180;
        let w_182 = w_11_squared * (w_10 * w_167 - w_19 * w_165);
        let w_183 = platform_q0 * w_182 - w_76 * w_168;
        let w_184 = w_11_squared * (w_25 * w_165 - w_23 * w_167);
        let w_185 = platform_q0 * w_184 + w_76 * w_164;
        let w_186 = platform_q0 * w_180
            + w_11 * (platform_q2 * w_164 - platform_q1 * w_168);
        let w_187 = platform_q1 * w_182 + w_81 * w_168;
        let w_188 = w_81 * w_164 - w_83 * w_167 - w_84 * w_165;
        let w_189 = w_11 * (platform_q3 * w_164 + platform_q0 * w_168)
            - platform_q1 * w_180;
        let w_190 = platform_q1_dot
            * (w_166 * w_187 + w_169 * w_188 + a2_on_platform_z * w_189);
        let w_191 = w_88 * w_168 - w_89 * w_167 - w_90 * w_165;
        let w_192 = platform_q2 * w_184 + w_88 * w_164;
        let w_193 = w_11 * (platform_q3 * w_168 - platform_q0 * w_164)
            - platform_q2 * w_180;
        let w_194 = platform_q2_dot
            * (w_166 * w_191 + w_169 * w_192 + a2_on_platform_z * w_193);
        let w_195 = platform_q3_dot
            * (w_166 * w_178 - w_169 * w_179 - a2_on_platform_z * w_181)
            - platform_q0_dot
                * (w_166 * w_183 + w_169 * w_185 - a2_on_platform_z * w_186) - w_190
            - w_194;
        let w_171_squared = w_171 * w_171;
        let w_196 = w_101 * sin_a2_head_angle;
        let w_197 = w_101 * cos_a2_head_angle;
        let w_198 = w_36 * w_100 * (w_19 * w_196 - w_10 * w_197);
        let w_199 = w_36 * w_100 * (w_23 * w_197 - w_25 * w_196);
        let w_200 = w_169
            * (w_11_squared * (w_106 * w_165 - w_107 * w_167 + w_108 * w_173)
                + platform_q0 * w_199 + w_105 * w_164);
        let w_201 = w_36 * w_100 * (w_29 * w_197 + w_30 * w_196);
        let w_202 = a2_on_platform_z
            * (w_11_squared * (w_112 * w_167 + w_114 * w_165) - platform_q0 * w_201
                + w_11 * (platform_q2_dot * w_164 - platform_q1_dot * w_168));
        let w_203 = w_174 * w_183
            + w_166
                * (w_11_squared * (w_97 * w_165 + w_98 * w_167 + w_99 * w_172)
                    + platform_q0 * w_198 - w_105 * w_168) + w_175 * w_185 + w_200
            - w_176 * w_186 - w_202;
        let w_204 = w_166
            * (w_11_squared * (w_118 * w_165 + w_119 * w_167 + w_120 * w_172)
                + platform_q1 * w_198 + w_121 * w_168);
        let w_205 = a2_on_platform_z
            * (w_11_squared * (w_129 * w_167 - w_131 * w_165)
                + w_11 * (platform_q3_dot * w_164 + platform_q0_dot * w_168)
                + platform_q1 * w_201);
        let w_206 = w_174 * w_187 + w_204 + w_175 * w_188
            + w_169 * (w_121 * w_164 - w_123 * w_167 + w_125 * w_197 - w_128 * w_165)
            + w_176 * w_189 + w_205;
        let w_207 = w_169
            * (w_11_squared * (w_139 * w_165 - w_140 * w_167 + w_141 * w_173)
                + platform_q2 * w_199 + w_135 * w_164);
        let w_208 = a2_on_platform_z
            * (w_11_squared * (w_143 * w_167 - w_144 * w_165)
                + w_11 * (platform_q3_dot * w_168 - platform_q0_dot * w_164)
                + platform_q2 * w_201);
        let w_209 = w_174 * w_191
            + w_166 * (w_134 * w_165 + w_135 * w_168 - w_137 * w_167 + w_138 * w_196)
            + w_175 * w_192 + w_207 + w_176 * w_193 + w_208;
        let w_210 = w_169
            * (w_148 * w_164 - w_152 * w_167 + w_153 * w_197 - w_154 * w_165);
        let w_211 = a2_on_platform_z
            * (w_11_squared * (w_156 * w_167 - w_157 * w_165)
                + w_11 * (platform_q2_dot * w_168 + platform_q1_dot * w_164)
                + platform_q3 * w_201);
        let w_212 = w_174 * w_178
            + w_166 * (w_147 * w_165 + w_148 * w_168 + w_149 * w_167 - w_151 * w_196)
            - w_175 * w_179 - w_210 - w_176 * w_181 - w_211;
        let w_213 = S::from_f64(2.0)
            * (w_177 * (w_195 / w_171_squared)
                + (platform_q0_dot * w_203 + platform_q1_dot * w_206
                    + platform_q2_dot * w_209 - platform_q3_dot * w_212) / w_171);
        let w_214 = w_213
            + (platform_x_dot * w_174 + platform_y_dot * w_175 + platform_z_dot * w_176)
                / w_171
            - w_177
                * ((platform_x_dot * w_166 + platform_y_dot * w_169
                    + platform_z_dot * a2_on_platform_z) / w_171_squared);
        let w_215 = sin_w * w_162;
        let w_216 = w_163 * w_7;
        let w_217 = self.r * cos_b1_head_angle;
        let w_218 = w_15 * sin_b1_head_angle;
        let w_219 = platform_x - self.R * cos_b1_foot_angle - w_13 * w_217
            + w_20 * w_218;
        let w_220 = w_15 * cos_b1_head_angle;
        let w_221 = self.r * sin_b1_head_angle;
        let w_222 = platform_y - self.R * sin_b1_foot_angle + w_24 * w_220
            - w_26 * w_221;
        let w_223 = w_29 * w_220 + w_30 * w_218;
        let b1_on_platform_z = w_11 * w_223 + platform_z;
        let w_224 = w_219 * w_219 + w_222 * w_222 + b1_on_platform_z * b1_on_platform_z;
        let w_225 = w_40 * cos_b1_head_angle;
        let w_226 = w_40 * sin_b1_head_angle;
        let w_227 = platform_x_dot + w_39 * w_225 - w_44 * w_226 - w_50 * w_218;
        let w_228 = platform_y_dot + w_53 * w_220 - w_55 * w_225 + w_58 * w_226;
        let w_229 = w_11 * (w_60 * w_218 - w_61 * w_220)
            - w_11_squared * w_36 * (w_29 * w_225 + w_30 * w_226) + platform_z_dot;
        let w_230 = w_219 * w_227 + w_222 * w_228 + b1_on_platform_z * w_229;
        let w_231 = w_64 * w_221 + w_66 * w_220 + w_67 * w_218;
        let w_232 = w_64 * w_217 - w_69 * w_220 - w_71 * w_218;
        let w_233 = w_11_squared * w_223;
        let w_234 = w_11 * (platform_q2 * w_221 + platform_q1 * w_217)
            - platform_q3 * w_233;
        let w_235 = w_11_squared * (w_10 * w_220 - w_19 * w_218);
        let w_236 = platform_q0 * w_235 - w_76 * w_221;
        let w_237 = w_11_squared * (w_25 * w_218 - w_23 * w_220);
        let w_238 = platform_q0 * w_237 + w_76 * w_217;
        let w_239 = platform_q0 * w_233
            + w_11 * (platform_q2 * w_217 - platform_q1 * w_221);
        let w_240 = platform_q1 * w_235 + w_81 * w_221;
        let w_241 = w_81 * w_217 - w_83 * w_220 - w_84 * w_218;
        let w_242 = w_11 * (platform_q3 * w_217 + platform_q0 * w_221)
            - platform_q1 * w_233;
        let w_243 = platform_q1_dot
            * (w_219 * w_240 + w_222 * w_241 + b1_on_platform_z * w_242);
        let w_244 = w_88 * w_221 - w_89 * w_220 - w_90 * w_218;
        let w_245 = platform_q2 * w_237 + w_88 * w_217;
        let w_246 = w_11 * (platform_q3 * w_221 - platform_q0 * w_217)
            - platform_q2 * w_233;
        let w_247 = platform_q2_dot
            * (w_219 * w_244 + w_222 * w_245 + b1_on_platform_z * w_246);
        let w_248 = platform_q3_dot
            * (w_219 * w_231 - w_222 * w_232 - b1_on_platform_z * w_234)
            - platform_q0_dot
                * (w_219 * w_236 + w_222 * w_238 - b1_on_platform_z * w_239) - w_243
            - w_247;
        let w_224_squared = w_224 * w_224;
        let w_249 = w_101 * sin_b1_head_angle;
        let w_250 = w_101 * cos_b1_head_angle;
        let w_251 = w_36 * w_100 * (w_19 * w_249 - w_10 * w_250);
        let w_252 = w_36 * w_100 * (w_23 * w_250 - w_25 * w_249);
        let w_253 = w_222
            * (w_11_squared * (w_106 * w_218 - w_107 * w_220 + w_108 * w_226)
                + platform_q0 * w_252 + w_105 * w_217);
        let w_254 = w_36 * w_100 * (w_29 * w_250 + w_30 * w_249);
        let w_255 = b1_on_platform_z
            * (w_11_squared * (w_112 * w_220 + w_114 * w_218) - platform_q0 * w_254
                + w_11 * (platform_q2_dot * w_217 - platform_q1_dot * w_221));
        let w_256 = w_227 * w_236
            + w_219
                * (w_11_squared * (w_97 * w_218 + w_98 * w_220 + w_99 * w_225)
                    + platform_q0 * w_251 - w_105 * w_221) + w_228 * w_238 + w_253
            - w_229 * w_239 - w_255;
        let w_257 = w_219
            * (w_11_squared * (w_118 * w_218 + w_119 * w_220 + w_120 * w_225)
                + platform_q1 * w_251 + w_121 * w_221);
        let w_258 = b1_on_platform_z
            * (w_11_squared * (w_129 * w_220 - w_131 * w_218)
                + w_11 * (platform_q3_dot * w_217 + platform_q0_dot * w_221)
                + platform_q1 * w_254);
        let w_259 = w_227 * w_240 + w_257 + w_228 * w_241
            + w_222 * (w_121 * w_217 - w_123 * w_220 + w_125 * w_250 - w_128 * w_218)
            + w_229 * w_242 + w_258;
        let w_260 = w_222
            * (w_11_squared * (w_139 * w_218 - w_140 * w_220 + w_141 * w_226)
                + platform_q2 * w_252 + w_135 * w_217);
        let w_261 = b1_on_platform_z
            * (w_11_squared * (w_143 * w_220 - w_144 * w_218)
                + w_11 * (platform_q3_dot * w_221 - platform_q0_dot * w_217)
                + platform_q2 * w_254);
        let w_262 = w_227 * w_244
            + w_219 * (w_134 * w_218 + w_135 * w_221 - w_137 * w_220 + w_138 * w_249)
            + w_228 * w_245 + w_260 + w_229 * w_246 + w_261;
        let w_263 = w_222
            * (w_148 * w_217 - w_152 * w_220 + w_153 * w_250 - w_154 * w_218);
        let w_264 = b1_on_platform_z
            * (w_11_squared * (w_156 * w_220 - w_157 * w_218)
                + w_11 * (platform_q2_dot * w_221 + platform_q1_dot * w_217)
                + platform_q3 * w_254);
        let w_265 = w_227 * w_231
            + w_219 * (w_147 * w_218 + w_148 * w_221 + w_149 * w_220 - w_151 * w_249)
            - w_228 * w_232 - w_263 - w_229 * w_234 - w_264;
        let w_266 = S::from_f64(2.0)
            * (w_230 * (w_248 / w_224_squared)
                + (platform_q0_dot * w_256 + platform_q1_dot * w_259
                    + platform_q2_dot * w_262 - platform_q3_dot * w_265) / w_224);
        let w_267 = w_266
            + (platform_x_dot * w_227 + platform_y_dot * w_228 + platform_z_dot * w_229)
                / w_224
            - w_230
                * ((platform_x_dot * w_219 + platform_y_dot * w_222
                    + platform_z_dot * b1_on_platform_z) / w_224_squared);
        let w_268 = self.r * cos_b2_head_angle;
        let w_269 = w_15 * sin_b2_head_angle;
        let w_270 = platform_x - self.R * cos_b2_foot_angle - w_13 * w_268
            + w_20 * w_269;
        let w_271 = w_15 * cos_b2_head_angle;
        let w_272 = self.r * sin_b2_head_angle;
        let w_273 = platform_y - self.R * sin_b2_foot_angle + w_24 * w_271
            - w_26 * w_272;
        let w_274 = w_29 * w_271 + w_30 * w_269;
        let b2_on_platform_z = w_11 * w_274 + platform_z;
        let w_275 = w_270 * w_270 + w_273 * w_273 + b2_on_platform_z * b2_on_platform_z;
        let w_276 = w_40 * cos_b2_head_angle;
        let w_277 = w_40 * sin_b2_head_angle;
        let w_278 = platform_x_dot + w_39 * w_276 - w_44 * w_277 - w_50 * w_269;
        let w_279 = platform_y_dot + w_53 * w_271 - w_55 * w_276 + w_58 * w_277;
        let w_280 = w_11 * (w_60 * w_269 - w_61 * w_271)
            - w_11_squared * w_36 * (w_29 * w_276 + w_30 * w_277) + platform_z_dot;
        let w_281 = w_270 * w_278 + w_273 * w_279 + b2_on_platform_z * w_280;
        let w_282 = w_64 * w_272 + w_66 * w_271 + w_67 * w_269;
        let w_283 = w_64 * w_268 - w_69 * w_271 - w_71 * w_269;
        let w_284 = w_11_squared * w_274;
        let w_285 = w_11 * (platform_q2 * w_272 + platform_q1 * w_268)
            - platform_q3 * w_284;
        let w_286 = w_11_squared * (w_10 * w_271 - w_19 * w_269);
        let w_287 = platform_q0 * w_286 - w_76 * w_272;
        let w_288 = w_11_squared * (w_25 * w_269 - w_23 * w_271);
        let w_289 = platform_q0 * w_288 + w_76 * w_268;
        let w_290 = platform_q0 * w_284
            + w_11 * (platform_q2 * w_268 - platform_q1 * w_272);
        let w_291 = platform_q1 * w_286 + w_81 * w_272;
        let w_292 = w_81 * w_268 - w_83 * w_271 - w_84 * w_269;
        let w_293 = w_11 * (platform_q3 * w_268 + platform_q0 * w_272)
            - platform_q1 * w_284;
        let w_294 = platform_q1_dot
            * (w_270 * w_291 + w_273 * w_292 + b2_on_platform_z * w_293);
        let w_295 = w_88 * w_272 - w_89 * w_271 - w_90 * w_269;
        let w_296 = platform_q2 * w_288 + w_88 * w_268;
        let w_297 = w_11 * (platform_q3 * w_272 - platform_q0 * w_268)
            - platform_q2 * w_284;
        let w_298 = platform_q2_dot
            * (w_270 * w_295 + w_273 * w_296 + b2_on_platform_z * w_297);
        let w_299 = platform_q3_dot
            * (w_270 * w_282 - w_273 * w_283 - b2_on_platform_z * w_285)
            - platform_q0_dot
                * (w_270 * w_287 + w_273 * w_289 - b2_on_platform_z * w_290) - w_294
            - w_298;
        let w_275_squared = w_275 * w_275;
        let w_300 = w_101 * sin_b2_head_angle;
        let w_301 = w_101 * cos_b2_head_angle;
        let w_302 = w_36 * w_100 * (w_19 * w_300 - w_10 * w_301);
        let w_303 = w_36 * w_100 * (w_23 * w_301 - w_25 * w_300);
        let w_304 = w_273
            * (w_11_squared * (w_106 * w_269 - w_107 * w_271 + w_108 * w_277)
                + platform_q0 * w_303 + w_105 * w_268);
        let w_305 = w_36 * w_100 * (w_29 * w_301 + w_30 * w_300);
        let w_306 = b2_on_platform_z
            * (w_11_squared * (w_112 * w_271 + w_114 * w_269) - platform_q0 * w_305
                + w_11 * (platform_q2_dot * w_268 - platform_q1_dot * w_272));
        let w_307 = w_278 * w_287
            + w_270
                * (w_11_squared * (w_97 * w_269 + w_98 * w_271 + w_99 * w_276)
                    + platform_q0 * w_302 - w_105 * w_272) + w_279 * w_289 + w_304
            - w_280 * w_290 - w_306;
        let w_308 = w_270
            * (w_11_squared * (w_118 * w_269 + w_119 * w_271 + w_120 * w_276)
                + platform_q1 * w_302 + w_121 * w_272);
        let w_309 = b2_on_platform_z
            * (w_11_squared * (w_129 * w_271 - w_131 * w_269)
                + w_11 * (platform_q3_dot * w_268 + platform_q0_dot * w_272)
                + platform_q1 * w_305);
        let w_310 = w_278 * w_291 + w_308 + w_279 * w_292
            + w_273 * (w_121 * w_268 - w_123 * w_271 + w_125 * w_301 - w_128 * w_269)
            + w_280 * w_293 + w_309;
        let w_311 = w_273
            * (w_11_squared * (w_139 * w_269 - w_140 * w_271 + w_141 * w_277)
                + platform_q2 * w_303 + w_135 * w_268);
        let w_312 = b2_on_platform_z
            * (w_11_squared * (w_143 * w_271 - w_144 * w_269)
                + w_11 * (platform_q3_dot * w_272 - platform_q0_dot * w_268)
                + platform_q2 * w_305);
        let w_313 = w_278 * w_295
            + w_270 * (w_134 * w_269 + w_135 * w_272 - w_137 * w_271 + w_138 * w_300)
            + w_279 * w_296 + w_311 + w_280 * w_297 + w_312;
        let w_314 = w_273
            * (w_148 * w_268 - w_152 * w_271 + w_153 * w_301 - w_154 * w_269);
        let w_315 = b2_on_platform_z
            * (w_11_squared * (w_156 * w_271 - w_157 * w_269)
                + w_11 * (platform_q2_dot * w_272 + platform_q1_dot * w_268)
                + platform_q3 * w_305);
        let w_316 = w_278 * w_282
            + w_270 * (w_147 * w_269 + w_148 * w_272 + w_149 * w_271 - w_151 * w_300)
            - w_279 * w_283 - w_314 - w_280 * w_285 - w_315;
        let w_317 = S::from_f64(2.0)
            * (w_281 * (w_299 / w_275_squared)
                + (platform_q0_dot * w_307 + platform_q1_dot * w_310
                    + platform_q2_dot * w_313 - platform_q3_dot * w_316) / w_275);
        let w_318 = w_317
            + (platform_x_dot * w_278 + platform_y_dot * w_279 + platform_z_dot * w_280)
                / w_275
            - w_281
                * ((platform_x_dot * w_270 + platform_y_dot * w_273
                    + platform_z_dot * b2_on_platform_z) / w_275_squared);
        let w_319 = w_163 * w_8;
        let w_320 = self.r * cos_c1_head_angle;
        let w_321 = w_15 * sin_c1_head_angle;
        let w_322 = platform_x - self.R * cos_c1_foot_angle - w_13 * w_320
            + w_20 * w_321;
        let w_323 = w_15 * cos_c1_head_angle;
        let w_324 = self.r * sin_c1_head_angle;
        let w_325 = platform_y - self.R * sin_c1_foot_angle + w_24 * w_323
            - w_26 * w_324;
        let w_326 = w_29 * w_323 + w_30 * w_321;
        let c1_on_platform_z = w_11 * w_326 + platform_z;
        let w_327 = w_322 * w_322 + w_325 * w_325 + c1_on_platform_z * c1_on_platform_z;
        let w_328 = w_40 * cos_c1_head_angle;
        let w_329 = w_40 * sin_c1_head_angle;
        let w_330 = platform_x_dot + w_39 * w_328 - w_44 * w_329 - w_50 * w_321;
        let w_331 = platform_y_dot + w_53 * w_323 - w_55 * w_328 + w_58 * w_329;
        let w_332 = w_11 * (w_60 * w_321 - w_61 * w_323)
            - w_11_squared * w_36 * (w_29 * w_328 + w_30 * w_329) + platform_z_dot;
        let w_333 = w_322 * w_330 + w_325 * w_331 + c1_on_platform_z * w_332;
        let w_334 = w_64 * w_324 + w_66 * w_323 + w_67 * w_321;
        let w_335 = w_64 * w_320 - w_69 * w_323 - w_71 * w_321;
        let w_336 = w_11_squared * w_326;
        let w_337 = w_11 * (platform_q2 * w_324 + platform_q1 * w_320)
            - platform_q3 * w_336;
        let w_338 = w_11_squared * (w_10 * w_323 - w_19 * w_321);
        let w_339 = platform_q0 * w_338 - w_76 * w_324;
        let w_340 = w_11_squared * (w_25 * w_321 - w_23 * w_323);
        let w_341 = platform_q0 * w_340 + w_76 * w_320;
        let w_342 = platform_q0 * w_336
            + w_11 * (platform_q2 * w_320 - platform_q1 * w_324);
        let w_343 = platform_q1 * w_338 + w_81 * w_324;
        let w_344 = w_81 * w_320 - w_83 * w_323 - w_84 * w_321;
        let w_345 = w_11 * (platform_q3 * w_320 + platform_q0 * w_324)
            - platform_q1 * w_336;
        let w_346 = platform_q1_dot
            * (w_322 * w_343 + w_325 * w_344 + c1_on_platform_z * w_345);
        let w_347 = w_88 * w_324 - w_89 * w_323 - w_90 * w_321;
        let w_348 = platform_q2 * w_340 + w_88 * w_320;
        let w_349 = w_11 * (platform_q3 * w_324 - platform_q0 * w_320)
            - platform_q2 * w_336;
        let w_350 = platform_q2_dot
            * (w_322 * w_347 + w_325 * w_348 + c1_on_platform_z * w_349);
        let w_351 = platform_q3_dot
            * (w_322 * w_334 - w_325 * w_335 - c1_on_platform_z * w_337)
            - platform_q0_dot
                * (w_322 * w_339 + w_325 * w_341 - c1_on_platform_z * w_342) - w_346
            - w_350;
        let w_327_squared = w_327 * w_327;
        let w_352 = w_101 * sin_c1_head_angle;
        let w_353 = w_101 * cos_c1_head_angle;
        let w_354 = w_36 * w_100 * (w_19 * w_352 - w_10 * w_353);
        let w_355 = w_36 * w_100 * (w_23 * w_353 - w_25 * w_352);
        let w_356 = w_325
            * (w_11_squared * (w_106 * w_321 - w_107 * w_323 + w_108 * w_329)
                + platform_q0 * w_355 + w_105 * w_320);
        let w_357 = w_36 * w_100 * (w_29 * w_353 + w_30 * w_352);
        let w_358 = c1_on_platform_z
            * (w_11_squared * (w_112 * w_323 + w_114 * w_321) - platform_q0 * w_357
                + w_11 * (platform_q2_dot * w_320 - platform_q1_dot * w_324));
        let w_359 = w_330 * w_339
            + w_322
                * (w_11_squared * (w_97 * w_321 + w_98 * w_323 + w_99 * w_328)
                    + platform_q0 * w_354 - w_105 * w_324) + w_331 * w_341 + w_356
            - w_332 * w_342 - w_358;
        let w_360 = w_322
            * (w_11_squared * (w_118 * w_321 + w_119 * w_323 + w_120 * w_328)
                + platform_q1 * w_354 + w_121 * w_324);
        let w_361 = c1_on_platform_z
            * (w_11_squared * (w_129 * w_323 - w_131 * w_321)
                + w_11 * (platform_q3_dot * w_320 + platform_q0_dot * w_324)
                + platform_q1 * w_357);
        let w_362 = w_330 * w_343 + w_360 + w_331 * w_344
            + w_325 * (w_121 * w_320 - w_123 * w_323 + w_125 * w_353 - w_128 * w_321)
            + w_332 * w_345 + w_361;
        let w_363 = w_325
            * (w_11_squared * (w_139 * w_321 - w_140 * w_323 + w_141 * w_329)
                + platform_q2 * w_355 + w_135 * w_320);
        let w_364 = c1_on_platform_z
            * (w_11_squared * (w_143 * w_323 - w_144 * w_321)
                + w_11 * (platform_q3_dot * w_324 - platform_q0_dot * w_320)
                + platform_q2 * w_357);
        let w_365 = w_330 * w_347
            + w_322 * (w_134 * w_321 + w_135 * w_324 - w_137 * w_323 + w_138 * w_352)
            + w_331 * w_348 + w_363 + w_332 * w_349 + w_364;
        let w_366 = w_325
            * (w_148 * w_320 - w_152 * w_323 + w_153 * w_353 - w_154 * w_321);
        let w_367 = c1_on_platform_z
            * (w_11_squared * (w_156 * w_323 - w_157 * w_321)
                + w_11 * (platform_q2_dot * w_324 + platform_q1_dot * w_320)
                + platform_q3 * w_357);
        let w_368 = w_330 * w_334
            + w_322 * (w_147 * w_321 + w_148 * w_324 + w_149 * w_323 - w_151 * w_352)
            - w_331 * w_335 - w_366 - w_332 * w_337 - w_367;
        let w_369 = S::from_f64(2.0)
            * (w_333 * (w_351 / w_327_squared)
                + (platform_q0_dot * w_359 + platform_q1_dot * w_362
                    + platform_q2_dot * w_365 - platform_q3_dot * w_368) / w_327);
        let w_370 = w_369
            + (platform_x_dot * w_330 + platform_y_dot * w_331 + platform_z_dot * w_332)
                / w_327
            - w_333
                * ((platform_x_dot * w_322 + platform_y_dot * w_325
                    + platform_z_dot * c1_on_platform_z) / w_327_squared);
        let w_371 = self.r * cos_c2_head_angle;
        let w_372 = w_15 * sin_c2_head_angle;
        let w_373 = platform_x - self.R * cos_c2_foot_angle - w_13 * w_371
            + w_20 * w_372;
        let w_374 = w_15 * cos_c2_head_angle;
        let w_375 = self.r * sin_c2_head_angle;
        let w_376 = platform_y - self.R * sin_c2_foot_angle + w_24 * w_374
            - w_26 * w_375;
        let w_377 = w_29 * w_374 + w_30 * w_372;
        let c2_on_platform_z = w_11 * w_377 + platform_z;
        let w_378 = w_373 * w_373 + w_376 * w_376 + c2_on_platform_z * c2_on_platform_z;
        let w_379 = w_40 * cos_c2_head_angle;
        let w_380 = w_40 * sin_c2_head_angle;
        let w_381 = platform_x_dot + w_39 * w_379 - w_44 * w_380 - w_50 * w_372;
        let w_382 = platform_y_dot + w_53 * w_374 - w_55 * w_379 + w_58 * w_380;
        let w_383 = w_11 * (w_60 * w_372 - w_61 * w_374)
            - w_11_squared * w_36 * (w_29 * w_379 + w_30 * w_380) + platform_z_dot;
        let w_384 = w_373 * w_381 + w_376 * w_382 + c2_on_platform_z * w_383;
        let w_385 = w_64 * w_375 + w_66 * w_374 + w_67 * w_372;
        let w_386 = w_64 * w_371 - w_69 * w_374 - w_71 * w_372;
        let w_387 = w_11_squared * w_377;
        let w_388 = w_11 * (platform_q2 * w_375 + platform_q1 * w_371)
            - platform_q3 * w_387;
        let w_389 = w_11_squared * (w_10 * w_374 - w_19 * w_372);
        let w_390 = platform_q0 * w_389 - w_76 * w_375;
        let w_391 = w_11_squared * (w_25 * w_372 - w_23 * w_374);
        let w_392 = platform_q0 * w_391 + w_76 * w_371;
        let w_393 = platform_q0 * w_387
            + w_11 * (platform_q2 * w_371 - platform_q1 * w_375);
        let w_394 = platform_q1 * w_389 + w_81 * w_375;
        let w_395 = w_81 * w_371 - w_83 * w_374 - w_84 * w_372;
        let w_396 = w_11 * (platform_q3 * w_371 + platform_q0 * w_375)
            - platform_q1 * w_387;
        let w_397 = platform_q1_dot
            * (w_373 * w_394 + w_376 * w_395 + c2_on_platform_z * w_396);
        let w_398 = w_88 * w_375 - w_89 * w_374 - w_90 * w_372;
        let w_399 = platform_q2 * w_391 + w_88 * w_371;
        let w_400 = w_11 * (platform_q3 * w_375 - platform_q0 * w_371)
            - platform_q2 * w_387;
        let w_401 = platform_q2_dot
            * (w_373 * w_398 + w_376 * w_399 + c2_on_platform_z * w_400);
        let w_402 = platform_q3_dot
            * (w_373 * w_385 - w_376 * w_386 - c2_on_platform_z * w_388)
            - platform_q0_dot
                * (w_373 * w_390 + w_376 * w_392 - c2_on_platform_z * w_393) - w_397
            - w_401;
        let w_378_squared = w_378 * w_378;
        let w_403 = w_101 * sin_c2_head_angle;
        let w_404 = w_101 * cos_c2_head_angle;
        let w_405 = w_36 * w_100 * (w_19 * w_403 - w_10 * w_404);
        let w_406 = w_36 * w_100 * (w_23 * w_404 - w_25 * w_403);
        let w_407 = w_376
            * (w_11_squared * (w_106 * w_372 - w_107 * w_374 + w_108 * w_380)
                + platform_q0 * w_406 + w_105 * w_371);
        let w_408 = w_36 * w_100 * (w_29 * w_404 + w_30 * w_403);
        let w_409 = c2_on_platform_z
            * (w_11_squared * (w_112 * w_374 + w_114 * w_372) - platform_q0 * w_408
                + w_11 * (platform_q2_dot * w_371 - platform_q1_dot * w_375));
        let w_410 = w_381 * w_390
            + w_373
                * (w_11_squared * (w_97 * w_372 + w_98 * w_374 + w_99 * w_379)
                    + platform_q0 * w_405 - w_105 * w_375) + w_382 * w_392 + w_407
            - w_383 * w_393 - w_409;
        let w_411 = w_373
            * (w_11_squared * (w_118 * w_372 + w_119 * w_374 + w_120 * w_379)
                + platform_q1 * w_405 + w_121 * w_375);
        let w_412 = c2_on_platform_z
            * (w_11_squared * (w_129 * w_374 - w_131 * w_372)
                + w_11 * (platform_q3_dot * w_371 + platform_q0_dot * w_375)
                + platform_q1 * w_408);
        let w_413 = w_381 * w_394 + w_411 + w_382 * w_395
            + w_376 * (w_121 * w_371 - w_123 * w_374 + w_125 * w_404 - w_128 * w_372)
            + w_383 * w_396 + w_412;
        let w_414 = w_376
            * (w_11_squared * (w_139 * w_372 - w_140 * w_374 + w_141 * w_380)
                + platform_q2 * w_406 + w_135 * w_371);
        let w_415 = c2_on_platform_z
            * (w_11_squared * (w_143 * w_374 - w_144 * w_372)
                + w_11 * (platform_q3_dot * w_375 - platform_q0_dot * w_371)
                + platform_q2 * w_408);
        let w_416 = w_381 * w_398
            + w_373 * (w_134 * w_372 + w_135 * w_375 - w_137 * w_374 + w_138 * w_403)
            + w_382 * w_399 + w_414 + w_383 * w_400 + w_415;
        let w_417 = w_376
            * (w_148 * w_371 - w_152 * w_374 + w_153 * w_404 - w_154 * w_372);
        let w_418 = c2_on_platform_z
            * (w_11_squared * (w_156 * w_374 - w_157 * w_372)
                + w_11 * (platform_q2_dot * w_375 + platform_q1_dot * w_371)
                + platform_q3 * w_408);
        let w_419 = w_381 * w_385
            + w_373 * (w_147 * w_372 + w_148 * w_375 + w_149 * w_374 - w_151 * w_403)
            - w_382 * w_386 - w_417 - w_383 * w_388 - w_418;
        let w_420 = S::from_f64(2.0)
            * (w_384 * (w_402 / w_378_squared)
                + (platform_q0_dot * w_410 + platform_q1_dot * w_413
                    + platform_q2_dot * w_416 - platform_q3_dot * w_419) / w_378);
        let w_421 = w_420
            + (platform_x_dot * w_381 + platform_y_dot * w_382 + platform_z_dot * w_383)
                / w_378
            - w_384
                * ((platform_x_dot * w_373 + platform_y_dot * w_376
                    + platform_z_dot * c2_on_platform_z) / w_378_squared);
        [
            S::from_f64(2.0)
                * (platform_q0_dot * platform_q0_dot + platform_q1_dot * platform_q1_dot
                    + platform_q2_dot * platform_q2_dot
                    + platform_q3_dot * platform_q3_dot),
            w_32.sqrt() * w_161 + sin_w * (w_162 + w_163),
            w_171.sqrt() * w_214 + w_215 - w_216,
            w_224.sqrt() * w_267 + w_215 + w_216,
            w_275.sqrt() * w_318 + w_215 - w_319,
            w_327.sqrt() * w_370 + w_215 + w_319,
            w_378.sqrt() * w_421 + w_215 - w_163 * w_9,
        ]
    }
    /// `C` (7), `C_q` (7 x 7) and `C_t` (7) together, in SI units, for projection.
    ///
    /// Operations: 304 additions, 530 multiplications, 43 divisions, 16 sine-cosine pairs, 6 square roots.
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
        let w_10 = platform_q2_squared + platform_q3_squared;
        let w_11 = S::from_f64(1.0)
            / (platform_q0_squared + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_12 = S::from_f64(2.0) * w_11;
        let w_13 = w_10 * w_12 - S::from_f64(1.0);
        let w_14 = self.r * cos_a1_head_angle;
        let w_15 = self.r * S::from_f64(2.0);
        let w_16 = sin_a1_head_angle * w_15;
        let w_17 = platform_q1 * platform_q2;
        let w_18 = platform_q0 * platform_q3;
        let w_19 = w_17 - w_18;
        let w_20 = w_11 * w_19;
        let w_21 = platform_x - self.R * cos_foot - w_13 * w_14 + w_16 * w_20;
        let w_22 = cos_a1_head_angle * w_15;
        let w_23 = w_17 + w_18;
        let w_24 = w_11 * w_23;
        let w_25 = platform_q1_squared + platform_q3_squared;
        let w_26 = w_12 * w_25 - S::from_f64(1.0);
        let w_27 = self.r * sin_a1_head_angle;
        let w_28 = platform_y - self.R * sin_foot + w_22 * w_24 - w_26 * w_27;
        let w_29 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_30 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let w_31 = w_22 * w_29 + w_16 * w_30;
        let a1_on_platform_z = w_11 * w_31 + platform_z;
        let w_32 = w_21 * w_21 + w_28 * w_28 + a1_on_platform_z * a1_on_platform_z;
        let sqrt_w_32 = w_32.sqrt();
        let w_33 = self.r * cos_a2_head_angle;
        let w_34 = w_15 * sin_a2_head_angle;
        let w_35 = platform_x - self.R * cos_a2_foot_angle - w_13 * w_33 + w_20 * w_34;
        let w_36 = w_15 * cos_a2_head_angle;
        let w_37 = self.r * sin_a2_head_angle;
        let w_38 = platform_y - self.R * sin_a2_foot_angle + w_24 * w_36 - w_26 * w_37;
        let w_39 = w_29 * w_36 + w_30 * w_34;
        let a2_on_platform_z = w_11 * w_39 + platform_z;
        let w_40 = w_35 * w_35 + w_38 * w_38 + a2_on_platform_z * a2_on_platform_z;
        let sqrt_w_40 = w_40.sqrt();
        let w_41 = self.heave * sin_w_2;
        let w_42 = self.sway * sin_w_4;
        let w_43 = self.r * cos_b1_head_angle;
        let w_44 = w_15 * sin_b1_head_angle;
        let w_45 = platform_x - self.R * cos_b1_foot_angle - w_13 * w_43 + w_20 * w_44;
        let w_46 = w_15 * cos_b1_head_angle;
        let w_47 = self.r * sin_b1_head_angle;
        let w_48 = platform_y - self.R * sin_b1_foot_angle + w_24 * w_46 - w_26 * w_47;
        let w_49 = w_29 * w_46 + w_30 * w_44;
        let b1_on_platform_z = w_11 * w_49 + platform_z;
        let w_50 = w_45 * w_45 + w_48 * w_48 + b1_on_platform_z * b1_on_platform_z;
        let sqrt_w_50 = w_50.sqrt();
        let w_51 = self.r * cos_b2_head_angle;
        let w_52 = w_15 * sin_b2_head_angle;
        let w_53 = platform_x - self.R * cos_b2_foot_angle - w_13 * w_51 + w_20 * w_52;
        let w_54 = w_15 * cos_b2_head_angle;
        let w_55 = self.r * sin_b2_head_angle;
        let w_56 = platform_y - self.R * sin_b2_foot_angle + w_24 * w_54 - w_26 * w_55;
        let w_57 = w_29 * w_54 + w_30 * w_52;
        let b2_on_platform_z = w_11 * w_57 + platform_z;
        let w_58 = w_53 * w_53 + w_56 * w_56 + b2_on_platform_z * b2_on_platform_z;
        let sqrt_w_58 = w_58.sqrt();
        let w_59 = self.sway * sin_w_6;
        let w_60 = self.r * cos_c1_head_angle;
        let w_61 = w_15 * sin_c1_head_angle;
        let w_62 = platform_x - self.R * cos_c1_foot_angle - w_13 * w_60 + w_20 * w_61;
        let w_63 = w_15 * cos_c1_head_angle;
        let w_64 = self.r * sin_c1_head_angle;
        let w_65 = platform_y - self.R * sin_c1_foot_angle + w_24 * w_63 - w_26 * w_64;
        let w_66 = w_29 * w_63 + w_30 * w_61;
        let c1_on_platform_z = w_11 * w_66 + platform_z;
        let w_67 = w_62 * w_62 + w_65 * w_65 + c1_on_platform_z * c1_on_platform_z;
        let sqrt_w_67 = w_67.sqrt();
        let w_68 = self.r * cos_c2_head_angle;
        let w_69 = w_15 * sin_c2_head_angle;
        let w_70 = platform_x - self.R * cos_c2_foot_angle - w_13 * w_68 + w_20 * w_69;
        let w_71 = w_15 * cos_c2_head_angle;
        let w_72 = self.r * sin_c2_head_angle;
        let w_73 = platform_y - self.R * sin_c2_foot_angle + w_24 * w_71 - w_26 * w_72;
        let w_74 = w_29 * w_71 + w_30 * w_69;
        let c2_on_platform_z = w_11 * w_74 + platform_z;
        let w_75 = w_70 * w_70 + w_73 * w_73 + c2_on_platform_z * c2_on_platform_z;
        let sqrt_w_75 = w_75.sqrt();
        let w_11_squared = w_11 * w_11;
        let w_76 = w_11_squared * (w_10 * w_22 - w_19 * w_16);
        let w_77 = platform_q3 * w_11;
        let w_78 = w_11_squared * (w_16 * w_25 - w_23 * w_22);
        let w_79 = w_31 * w_11_squared;
        let w_80 = a1_on_platform_z
            * (platform_q0 * w_79 + w_11 * (platform_q2 * w_14 - platform_q1 * w_27));
        let w_81 = S::from_f64(2.0) * sqrt_w_32;
        let w_82 = platform_q2 * w_11;
        let w_83 = w_11_squared * platform_q1 * w_23;
        let w_84 = w_11 - w_25 * w_11_squared;
        let w_85 = platform_q1 * w_84;
        let w_86 = a1_on_platform_z
            * (w_11 * (platform_q3 * w_14 + platform_q0 * w_27) - platform_q1 * w_79);
        let w_87 = platform_q1 * w_11;
        let w_88 = w_11 - w_10 * w_11_squared;
        let w_89 = platform_q2 * w_88;
        let w_90 = w_11_squared * platform_q2 * w_19;
        let w_91 = a1_on_platform_z
            * (w_11 * (platform_q3 * w_27 - platform_q0 * w_14) - platform_q2 * w_79);
        let w_92 = platform_q0 * w_11;
        let w_93 = platform_q3 * w_88;
        let w_94 = platform_q3 * w_11_squared;
        let w_95 = w_19 * w_94;
        let w_96 = w_23 * w_94;
        let w_97 = platform_q3 * w_84;
        let w_98 = a1_on_platform_z
            * (w_11 * (platform_q2 * w_27 + platform_q1 * w_14) - platform_q3 * w_79);
        let w_99 = w_81
            * (w_21 * (w_27 * w_92 + w_22 * w_93 + w_16 * w_95)
                - w_28 * (w_14 * w_92 - w_22 * w_96 - w_16 * w_97) - w_98);
        let w_100 = w_11_squared * (w_10 * w_36 - w_19 * w_34);
        let w_101 = w_11_squared * (w_25 * w_34 - w_23 * w_36);
        let w_102 = w_39 * w_11_squared;
        let w_103 = a2_on_platform_z
            * (platform_q0 * w_102 + w_11 * (platform_q2 * w_33 - platform_q1 * w_37));
        let w_104 = S::from_f64(2.0) * sqrt_w_40;
        let w_105 = a2_on_platform_z
            * (w_11 * (platform_q3 * w_33 + platform_q0 * w_37) - platform_q1 * w_102);
        let w_106 = a2_on_platform_z
            * (w_11 * (platform_q3 * w_37 - platform_q0 * w_33) - platform_q2 * w_102);
        let w_107 = a2_on_platform_z
            * (w_11 * (platform_q2 * w_37 + platform_q1 * w_33) - platform_q3 * w_102);
        let w_108 = w_104
            * (w_35 * (w_37 * w_92 + w_36 * w_93 + w_34 * w_95)
                - w_38 * (w_33 * w_92 - w_36 * w_96 - w_34 * w_97) - w_107);
        let w_109 = w_11_squared * (w_10 * w_46 - w_19 * w_44);
        let w_110 = w_11_squared * (w_25 * w_44 - w_23 * w_46);
        let w_111 = w_49 * w_11_squared;
        let w_112 = b1_on_platform_z
            * (platform_q0 * w_111 + w_11 * (platform_q2 * w_43 - platform_q1 * w_47));
        let w_113 = S::from_f64(2.0) * sqrt_w_50;
        let w_114 = b1_on_platform_z
            * (w_11 * (platform_q3 * w_43 + platform_q0 * w_47) - platform_q1 * w_111);
        let w_115 = b1_on_platform_z
            * (w_11 * (platform_q3 * w_47 - platform_q0 * w_43) - platform_q2 * w_111);
        let w_116 = b1_on_platform_z
            * (w_11 * (platform_q2 * w_47 + platform_q1 * w_43) - platform_q3 * w_111);
        let w_117 = w_113
            * (w_45 * (w_47 * w_92 + w_46 * w_93 + w_44 * w_95)
                - w_48 * (w_43 * w_92 - w_46 * w_96 - w_44 * w_97) - w_116);
        let w_118 = w_11_squared * (w_10 * w_54 - w_19 * w_52);
        let w_119 = w_11_squared * (w_25 * w_52 - w_23 * w_54);
        let w_120 = w_57 * w_11_squared;
        let w_121 = b2_on_platform_z
            * (platform_q0 * w_120 + w_11 * (platform_q2 * w_51 - platform_q1 * w_55));
        let w_122 = S::from_f64(2.0) * sqrt_w_58;
        let w_123 = b2_on_platform_z
            * (w_11 * (platform_q3 * w_51 + platform_q0 * w_55) - platform_q1 * w_120);
        let w_124 = b2_on_platform_z
            * (w_11 * (platform_q3 * w_55 - platform_q0 * w_51) - platform_q2 * w_120);
        let w_125 = b2_on_platform_z
            * (w_11 * (platform_q2 * w_55 + platform_q1 * w_51) - platform_q3 * w_120);
        let w_126 = w_122
            * (w_53 * (w_55 * w_92 + w_54 * w_93 + w_52 * w_95)
                - w_56 * (w_51 * w_92 - w_54 * w_96 - w_52 * w_97) - w_125);
        let w_127 = w_11_squared * (w_10 * w_63 - w_19 * w_61);
        let w_128 = w_11_squared * (w_25 * w_61 - w_23 * w_63);
        let w_129 = w_66 * w_11_squared;
        let w_130 = c1_on_platform_z
            * (platform_q0 * w_129 + w_11 * (platform_q2 * w_60 - platform_q1 * w_64));
        let w_131 = S::from_f64(2.0) * sqrt_w_67;
        let w_132 = c1_on_platform_z
            * (w_11 * (platform_q3 * w_60 + platform_q0 * w_64) - platform_q1 * w_129);
        let w_133 = c1_on_platform_z
            * (w_11 * (platform_q3 * w_64 - platform_q0 * w_60) - platform_q2 * w_129);
        let w_134 = c1_on_platform_z
            * (w_11 * (platform_q2 * w_64 + platform_q1 * w_60) - platform_q3 * w_129);
        let w_135 = w_131
            * (w_62 * (w_64 * w_92 + w_63 * w_93 + w_61 * w_95)
                - w_65 * (w_60 * w_92 - w_63 * w_96 - w_61 * w_97) - w_134);
        let w_136 = w_11_squared * (w_10 * w_71 - w_19 * w_69);
        let w_137 = w_11_squared * (w_25 * w_69 - w_23 * w_71);
        let w_138 = w_74 * w_11_squared;
        let w_139 = c2_on_platform_z
            * (platform_q0 * w_138 + w_11 * (platform_q2 * w_68 - platform_q1 * w_72));
        let w_140 = S::from_f64(2.0) * sqrt_w_75;
        let w_141 = c2_on_platform_z
            * (w_11 * (platform_q3 * w_68 + platform_q0 * w_72) - platform_q1 * w_138);
        let w_142 = c2_on_platform_z
            * (w_11 * (platform_q3 * w_72 - platform_q0 * w_68) - platform_q2 * w_138);
        let w_143 = c2_on_platform_z
            * (w_11 * (platform_q2 * w_72 + platform_q1 * w_68) - platform_q3 * w_138);
        let w_144 = w_140
            * (w_70 * (w_72 * w_92 + w_71 * w_93 + w_69 * w_95)
                - w_73 * (w_68 * w_92 - w_71 * w_96 - w_69 * w_97) - w_143);
        let w_145 = self.heave * self.w;
        let w_146 = self.w * self.sway;
        let w_147 = w_146 * cos_w_4;
        let w_148 = cos_w_2 * w_145;
        let w_149 = w_146 * cos_w_6;
        sim_kernel::ConstraintLinearization {
            values: [
                platform_q0_squared + platform_q1_squared + platform_q2_squared
                    + platform_q3_squared - S::from_f64(1.0),
                sqrt_w_32 - self.L - sin_w_2 * (self.heave + self.sway),
                sqrt_w_40 - self.L - w_41 + w_42,
                sqrt_w_50 - self.L - w_41 - w_42,
                sqrt_w_58 - self.L - w_41 + w_59,
                sqrt_w_67 - self.L - w_41 - w_59,
                sqrt_w_75 - self.L - w_41 + self.sway * sin_w_9,
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
                    w_21 * sqrt_w_32 / w_32,
                    w_28 * sqrt_w_32 / w_32,
                    a1_on_platform_z * sqrt_w_32 / w_32,
                    (w_21 * (platform_q0 * w_76 - w_27 * w_77)
                        + w_28 * (platform_q0 * w_78 + w_14 * w_77) - w_80) * w_81
                        / w_32,
                    w_81
                        * (w_21 * (platform_q1 * w_76 + w_27 * w_82)
                            + w_28 * (w_14 * w_82 - w_22 * w_83 - w_16 * w_85) + w_86)
                        / w_32,
                    w_81
                        * (w_21 * (w_27 * w_87 - w_22 * w_89 - w_16 * w_90)
                            + w_28 * (platform_q2 * w_78 + w_14 * w_87) + w_91) / w_32,
                    -(w_99 / w_32),
                ],
                [
                    w_35 * sqrt_w_40 / w_40,
                    w_38 * sqrt_w_40 / w_40,
                    a2_on_platform_z * sqrt_w_40 / w_40,
                    (w_35 * (platform_q0 * w_100 - w_37 * w_77)
                        + w_38 * (platform_q0 * w_101 + w_33 * w_77) - w_103) * w_104
                        / w_40,
                    w_104
                        * (w_35 * (platform_q1 * w_100 + w_37 * w_82)
                            + w_38 * (w_33 * w_82 - w_36 * w_83 - w_34 * w_85) + w_105)
                        / w_40,
                    w_104
                        * (w_35 * (w_37 * w_87 - w_36 * w_89 - w_34 * w_90)
                            + w_38 * (platform_q2 * w_101 + w_33 * w_87) + w_106) / w_40,
                    -(w_108 / w_40),
                ],
                [
                    w_45 * sqrt_w_50 / w_50,
                    w_48 * sqrt_w_50 / w_50,
                    b1_on_platform_z * sqrt_w_50 / w_50,
                    (w_45 * (platform_q0 * w_109 - w_47 * w_77)
                        + w_48 * (platform_q0 * w_110 + w_43 * w_77) - w_112) * w_113
                        / w_50,
                    w_113
                        * (w_45 * (platform_q1 * w_109 + w_47 * w_82)
                            + w_48 * (w_43 * w_82 - w_46 * w_83 - w_44 * w_85) + w_114)
                        / w_50,
                    w_113
                        * (w_45 * (w_47 * w_87 - w_46 * w_89 - w_44 * w_90)
                            + w_48 * (platform_q2 * w_110 + w_43 * w_87) + w_115) / w_50,
                    -(w_117 / w_50),
                ],
                [
                    w_53 * sqrt_w_58 / w_58,
                    w_56 * sqrt_w_58 / w_58,
                    b2_on_platform_z * sqrt_w_58 / w_58,
                    (w_53 * (platform_q0 * w_118 - w_55 * w_77)
                        + w_56 * (platform_q0 * w_119 + w_51 * w_77) - w_121) * w_122
                        / w_58,
                    w_122
                        * (w_53 * (platform_q1 * w_118 + w_55 * w_82)
                            + w_56 * (w_51 * w_82 - w_54 * w_83 - w_52 * w_85) + w_123)
                        / w_58,
                    w_122
                        * (w_53 * (w_55 * w_87 - w_54 * w_89 - w_52 * w_90)
                            + w_56 * (platform_q2 * w_119 + w_51 * w_87) + w_124) / w_58,
                    -(w_126 / w_58),
                ],
                [
                    w_62 * sqrt_w_67 / w_67,
                    w_65 * sqrt_w_67 / w_67,
                    c1_on_platform_z * sqrt_w_67 / w_67,
                    (w_62 * (platform_q0 * w_127 - w_64 * w_77)
                        + w_65 * (platform_q0 * w_128 + w_60 * w_77) - w_130) * w_131
                        / w_67,
                    w_131
                        * (w_62 * (platform_q1 * w_127 + w_64 * w_82)
                            + w_65 * (w_60 * w_82 - w_63 * w_83 - w_61 * w_85) + w_132)
                        / w_67,
                    w_131
                        * (w_62 * (w_64 * w_87 - w_63 * w_89 - w_61 * w_90)
                            + w_65 * (platform_q2 * w_128 + w_60 * w_87) + w_133) / w_67,
                    -(w_135 / w_67),
                ],
                [
                    w_70 * sqrt_w_75 / w_75,
                    w_73 * sqrt_w_75 / w_75,
                    c2_on_platform_z * sqrt_w_75 / w_75,
                    (w_70 * (platform_q0 * w_136 - w_72 * w_77)
                        + w_73 * (platform_q0 * w_137 + w_68 * w_77) - w_139) * w_140
                        / w_75,
                    w_140
                        * (w_70 * (platform_q1 * w_136 + w_72 * w_82)
                            + w_73 * (w_68 * w_82 - w_71 * w_83 - w_69 * w_85) + w_141)
                        / w_75,
                    w_140
                        * (w_70 * (w_72 * w_87 - w_71 * w_89 - w_69 * w_90)
                            + w_73 * (platform_q2 * w_137 + w_68 * w_87) + w_142) / w_75,
                    -(w_144 / w_75),
                ],
            ],
            time_derivative: [
                S::from_f64(0.0),
                -(cos_w_2 * (w_145 + w_146)),
                w_147 - w_148,
                -(w_148 + w_147),
                w_149 - w_148,
                -(w_148 + w_149),
                w_146 * cos_w_9 - w_148,
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
    /// Operations: 58 additions, 99 multiplications, 1 division, 12 sine-cosine pairs.
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
        let platform_q2_squared = platform_q2 * platform_q2;
        let platform_q3_squared = platform_q3 * platform_q3;
        let platform_q1_squared = platform_q1 * platform_q1;
        let w_5 = S::from_f64(1.0)
            / (platform_q0 * platform_q0 + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_6 = S::from_f64(2.0) * w_5;
        let w_7 = (platform_q2_squared + platform_q3_squared) * w_6 - S::from_f64(1.0);
        let w_8 = self.r * S::from_f64(2.0);
        let w_9 = sin_a1_head_angle * w_8;
        let w_10 = platform_q1 * platform_q2;
        let w_11 = platform_q0 * platform_q3;
        let w_12 = w_5 * (w_10 - w_11);
        let a1_on_platform_x = platform_x - w_7 * self.r * cos_a1_head_angle
            + w_9 * w_12;
        let w_13 = cos_a1_head_angle * w_8;
        let w_14 = w_5 * (w_10 + w_11);
        let w_15 = w_6 * (platform_q1_squared + platform_q3_squared) - S::from_f64(1.0);
        let a1_on_platform_y = platform_y + w_13 * w_14
            - w_15 * self.r * sin_a1_head_angle;
        let w_16 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_17 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let a1_on_platform_z = w_5 * (w_13 * w_16 + w_9 * w_17) + platform_z;
        let a2_on_ground_x = self.R * cos_a2_foot_angle;
        let a2_on_ground_y = self.R * sin_a2_foot_angle;
        let w_18 = w_8 * sin_a2_head_angle;
        let a2_on_platform_x = platform_x - w_7 * self.r * cos_a2_head_angle
            + w_12 * w_18;
        let w_19 = w_8 * cos_a2_head_angle;
        let a2_on_platform_y = platform_y + w_14 * w_19
            - w_15 * self.r * sin_a2_head_angle;
        let a2_on_platform_z = w_5 * (w_16 * w_19 + w_17 * w_18) + platform_z;
        let b1_on_ground_x = self.R * cos_b1_foot_angle;
        let b1_on_ground_y = self.R * sin_b1_foot_angle;
        let w_20 = w_8 * sin_b1_head_angle;
        let b1_on_platform_x = platform_x - w_7 * self.r * cos_b1_head_angle
            + w_12 * w_20;
        let w_21 = w_8 * cos_b1_head_angle;
        let b1_on_platform_y = platform_y + w_14 * w_21
            - w_15 * self.r * sin_b1_head_angle;
        let b1_on_platform_z = w_5 * (w_16 * w_21 + w_17 * w_20) + platform_z;
        let b2_on_ground_x = self.R * cos_b2_foot_angle;
        let b2_on_ground_y = self.R * sin_b2_foot_angle;
        let w_22 = w_8 * sin_b2_head_angle;
        let b2_on_platform_x = platform_x - w_7 * self.r * cos_b2_head_angle
            + w_12 * w_22;
        let w_23 = w_8 * cos_b2_head_angle;
        let b2_on_platform_y = platform_y + w_14 * w_23
            - w_15 * self.r * sin_b2_head_angle;
        let b2_on_platform_z = w_5 * (w_16 * w_23 + w_17 * w_22) + platform_z;
        let c1_on_ground_x = self.R * cos_c1_foot_angle;
        let c1_on_ground_y = self.R * sin_c1_foot_angle;
        let w_24 = w_8 * sin_c1_head_angle;
        let c1_on_platform_x = platform_x - w_7 * self.r * cos_c1_head_angle
            + w_12 * w_24;
        let w_25 = w_8 * cos_c1_head_angle;
        let c1_on_platform_y = platform_y + w_14 * w_25
            - w_15 * self.r * sin_c1_head_angle;
        let c1_on_platform_z = w_5 * (w_16 * w_25 + w_17 * w_24) + platform_z;
        let c2_on_ground_x = self.R * cos_c2_foot_angle;
        let c2_on_ground_y = self.R * sin_c2_foot_angle;
        let w_26 = w_8 * sin_c2_head_angle;
        let c2_on_platform_x = platform_x - w_7 * self.r * cos_c2_head_angle
            + w_12 * w_26;
        let w_27 = w_8 * cos_c2_head_angle;
        let c2_on_platform_y = platform_y + w_14 * w_27
            - w_15 * self.r * sin_c2_head_angle;
        let c2_on_platform_z = w_5 * (w_16 * w_27 + w_17 * w_26) + platform_z;
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
    /// Operations: 1326 additions, 2004 multiplications, 78 divisions, 4 sine-cosine pairs, 6 square roots.
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
        let w_25 = w_20 * w_24;
        let w_26 = platform_q3 * w_25;
        let w_27 = w_11 * self.k_47;
        let w_28 = platform_q0_dot * platform_q0_dot + platform_q1_dot * platform_q1_dot
            + platform_q2_dot * platform_q2_dot + platform_q3_dot * platform_q3_dot;
        let w_29 = self.k_3 * w_28;
        let rhs_platform_q0 = S::from_f64(8.0) * w
            * (platform_q1 * w_22 + platform_q2 * w_23) - w_26 * w_27
            - platform_q0 * w_29;
        let w_30 = platform_q2 * w_25;
        let w_31 = self.k_3 - w_squared * self.k;
        let w_32 = platform_q2 * platform_q3;
        let mass_platform_q1_platform_q0 = platform_q1 * platform_q0 * w_31
            + w_squared * self.k_4 * w_32;
        let w_33 = self.k * (platform_q1_squared + platform_q2_squared);
        let mass_platform_q0_platform_q0 = w_squared
            * (w_33 + platform_q3_squared * self.k_2) + platform_q0_squared * self.k_3;
        let inverse_platform_q0 = S::from_f64(1.0) / mass_platform_q0_platform_q0;
        let l_platform_q1_platform_q0 = mass_platform_q1_platform_q0
            * inverse_platform_q0;
        let rhs_platform_q1 = S::from_f64(8.0) * w
            * (platform_q3 * w_23 - platform_q0 * w_22) + w_27 * w_30
            - platform_q1 * w_29 - rhs_platform_q0 * l_platform_q1_platform_q0;
        let w_34 = self.k_3 - w_squared * self.k_2;
        let mass_platform_q3_platform_q0 = platform_q0 * platform_q3 * w_34;
        let l_platform_q3_platform_q0 = mass_platform_q3_platform_q0
            * inverse_platform_q0;
        let w_35 = self.k * (platform_q0_squared + platform_q3_squared);
        let mass_platform_q1_platform_q1 = w_squared
            * (w_35 + platform_q2_squared * self.k_2) + platform_q1_squared * self.k_3;
        let pivot_platform_q1 = mass_platform_q1_platform_q1
            - mass_platform_q1_platform_q0 * l_platform_q1_platform_q0;
        let inverse_platform_q1 = S::from_f64(1.0) / pivot_platform_q1;
        let w_36 = platform_q0 * platform_q2;
        let k_platform_q3_platform_q1 = platform_q1 * platform_q3 * w_31
            + w_squared * self.k_5 * w_36
            - mass_platform_q1_platform_q0 * l_platform_q3_platform_q0;
        let l_platform_q3_platform_q1 = inverse_platform_q1 * k_platform_q3_platform_q1;
        let mass_platform_q2_platform_q2 = w_squared
            * (w_35 + platform_q1_squared * self.k_2) + platform_q2_squared * self.k_3;
        let w_37 = platform_q1 * platform_q3;
        let mass_platform_q2_platform_q0 = w_squared * (self.k_5 * w_37 - self.k * w_36)
            + self.k_3 * w_36;
        let l_platform_q2_platform_q0 = mass_platform_q2_platform_q0
            * inverse_platform_q0;
        let k_platform_q2_platform_q1 = platform_q1 * platform_q2 * w_34
            - mass_platform_q1_platform_q0 * l_platform_q2_platform_q0;
        let l_platform_q2_platform_q1 = inverse_platform_q1 * k_platform_q2_platform_q1;
        let pivot_platform_q2 = mass_platform_q2_platform_q2
            - mass_platform_q2_platform_q0 * l_platform_q2_platform_q0
            - k_platform_q2_platform_q1 * l_platform_q2_platform_q1;
        let inverse_platform_q2 = S::from_f64(1.0) / pivot_platform_q2;
        let w_38 = platform_q1 * platform_q0;
        let k_platform_q3_platform_q2 = w_squared * (self.k_4 * w_38 - self.k * w_32)
            + self.k_3 * w_32 - mass_platform_q2_platform_q0 * l_platform_q3_platform_q0
            - k_platform_q2_platform_q1 * l_platform_q3_platform_q1;
        let l_platform_q3_platform_q2 = inverse_platform_q2 * k_platform_q3_platform_q2;
        let w_39 = platform_q1 * w_25;
        let minus_rhs_platform_q2 = S::from_f64(8.0) * w
            * (platform_q3 * w_22 + platform_q0 * w_23) + w_27 * w_39
            + platform_q2 * w_29 + rhs_platform_q0 * l_platform_q2_platform_q0
            + l_platform_q2_platform_q1 * rhs_platform_q1;
        let rhs_platform_q3 = S::from_f64(8.0) * w
            * (platform_q2 * w_22 - platform_q1 * w_23) + platform_q0 * w_25 * w_27
            - platform_q3 * w_29 - rhs_platform_q0 * l_platform_q3_platform_q0
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
            * (w_33 + platform_q0_squared * self.k_2) + platform_q3_squared * self.k_3;
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
            * minus_rhs_platform_q2 - S::from_f64(2.0) * w_28
            - rhs_platform_q0 * l_lambda_platform_norm_platform_q0
            - l_lambda_platform_norm_platform_q1 * rhs_platform_q1
            - l_lambda_platform_norm_platform_q3 * rhs_platform_q3;
        let w_40 = platform_q2_squared + platform_q3_squared;
        let w_41 = w * S::from_f64(2.0);
        let w_42 = w_40 * w_41 - S::from_f64(1.0);
        let w_43 = platform_q1 * platform_q2;
        let w_44 = platform_q0 * platform_q3;
        let w_45 = w_43 - w_44;
        let w_46 = w * w_45;
        let w_47 = platform_x - self.k_6 - w_42 * self.k_7 + self.k_8 * w_46;
        let w_48 = w_43 + w_44;
        let w_49 = w * w_48;
        let w_50 = platform_q1_squared + platform_q3_squared;
        let w_51 = w_41 * w_50 - S::from_f64(1.0);
        let w_52 = platform_y - self.k_9 + self.k_10 * w_49 - w_51 * self.k_11;
        let w_53 = w_37 - w_36;
        let w_54 = w_32 + w_38;
        let w_55 = self.k_10 * w_53 + self.k_8 * w_54;
        let a1_on_platform_z = w * w_55 + platform_z;
        let w_56 = w_47 * w_47 + w_52 * w_52 + a1_on_platform_z * a1_on_platform_z;
        let sqrt_w_56 = w_56.sqrt();
        let w_57 = S::from_f64(2.0) * sqrt_w_56;
        let w_58 = platform_q1 * w;
        let w_59 = w_squared * w_40;
        let w_60 = w - w_59;
        let w_61 = platform_q2 * w_60;
        let w_62 = w_squared * w_45;
        let w_63 = platform_q2 * w_62;
        let w_64 = self.k_11 * w_58 - self.k_10 * w_61 - self.k_8 * w_63;
        let w_65 = w_squared * (self.k_8 * w_50 - w_48 * self.k_10);
        let w_66 = platform_q2 * w_65 + self.k_7 * w_58;
        let w_67 = w_squared * w_55;
        let w_68 = w * (platform_q3 * self.k_11 - platform_q0 * self.k_7)
            - platform_q2 * w_67;
        let w_69 = w_47 * w_64 + w_52 * w_66 + a1_on_platform_z * w_68;
        let w_70 = w_squared * (w_40 * self.k_10 - w_45 * self.k_8);
        let w_71 = platform_q3 * w;
        let w_72 = platform_q0 * w_70 - self.k_11 * w_71;
        let w_73 = platform_q0 * w_65 + self.k_7 * w_71;
        let w_74 = platform_q0 * w_67
            + w * (platform_q2 * self.k_7 - platform_q1 * self.k_11);
        let w_75 = w_47 * w_72 + w_52 * w_73 - a1_on_platform_z * w_74;
        let a1_leg_by_platform_q0 = w_75 * w_57 / w_56;
        let l_lambda_a1_leg_platform_q0 = a1_leg_by_platform_q0 * inverse_platform_q0;
        let w_76 = platform_q2 * w;
        let w_77 = platform_q1 * w_70 + self.k_11 * w_76;
        let w_78 = w_squared * w_48;
        let w_79 = platform_q1 * w_78;
        let w_80 = w_squared * w_50;
        let w_81 = w - w_80;
        let w_82 = platform_q1 * w_81;
        let w_83 = self.k_7 * w_76 - self.k_10 * w_79 - self.k_8 * w_82;
        let w_84 = w * (platform_q3 * self.k_7 + platform_q0 * self.k_11)
            - platform_q1 * w_67;
        let w_85 = w_47 * w_77 + w_52 * w_83 + a1_on_platform_z * w_84;
        let k_lambda_a1_leg_platform_q1 = w_57 * w_85 / w_56
            - mass_platform_q1_platform_q0 * l_lambda_a1_leg_platform_q0;
        let l_lambda_a1_leg_platform_q1 = inverse_platform_q1
            * k_lambda_a1_leg_platform_q1;
        let k_lambda_a1_leg_platform_q2 = w_57 * w_69 / w_56
            - mass_platform_q2_platform_q0 * l_lambda_a1_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_a1_leg_platform_q1;
        let l_lambda_a1_leg_platform_q2 = inverse_platform_q2
            * k_lambda_a1_leg_platform_q2;
        let w_86 = w_18 + w_19;
        let w_87 = w_59 * w_20 - w * w_86;
        let w_88 = w_62 * w_20;
        let w_89 = w_7 + w_8 - w_9 - w_10;
        let w_90 = w * w_89;
        let w_91 = platform_x_dot + w_87 * self.k_48 - self.k_49 * w_88
            - self.k_8 * w_90;
        let w_92 = w_7 + w_8 + w_9 + w_10;
        let w_93 = w * w_92;
        let w_94 = w_78 * w_20;
        let w_95 = w_17 + w_19;
        let w_96 = w_80 * w_20 - w * w_95;
        let w_97 = platform_y_dot + self.k_10 * w_93 - self.k_48 * w_94
            + self.k_49 * w_96;
        let w_98 = w_12 + w_13 + w_14 + w_15;
        let w_99 = w_2 + w_3 - w_4 - w_5;
        let w_100 = w * (self.k_8 * w_98 - self.k_10 * w_99)
            - w_squared * w_20 * (w_53 * self.k_48 + w_54 * self.k_49) + platform_z_dot;
        let w_101 = w_47 * w_91 + w_52 * w_97 + a1_on_platform_z * w_100;
        let w_102 = platform_q0 * w;
        let w_103 = platform_q3 * w_60;
        let w_104 = platform_q3 * w_62;
        let w_105 = self.k_11 * w_102 + self.k_10 * w_103 + self.k_8 * w_104;
        let w_106 = platform_q3 * w_78;
        let w_107 = platform_q3 * w_81;
        let w_108 = self.k_7 * w_102 - self.k_10 * w_106 - self.k_8 * w_107;
        let w_109 = w * (platform_q2 * self.k_11 + platform_q1 * self.k_7)
            - platform_q3 * w_67;
        let w_110 = w_47 * w_105 - w_52 * w_108 - a1_on_platform_z * w_109;
        let w_56_squared = w_56 * w_56;
        let w_111 = w_101
            * ((w_110 * platform_q3_dot - w_75 * platform_q0_dot - w_85 * platform_q1_dot
                - w_69 * platform_q2_dot) / w_56_squared);
        let w_112 = platform_q3 * w_20;
        let w_113 = platform_q0 * w_89 - w_45 * platform_q0_dot + w_112;
        let w_114 = w_40 * platform_q0_dot;
        let w_115 = platform_q0 * w_86;
        let w_116 = w_20 * w_24 * (w_45 * self.k_51 - w_40 * self.k_50);
        let w_117 = w * platform_q3_dot;
        let w_118 = w_50 * platform_q0_dot;
        let w_119 = w_112 + w_48 * platform_q0_dot + platform_q0 * w_92;
        let w_120 = platform_q0 * w_95;
        let w_121 = w_20 * w_24 * (w_48 * self.k_50 - w_50 * self.k_51);
        let w_122 = w_52
            * (w_squared * (self.k_8 * w_118 - self.k_10 * w_119 + self.k_49 * w_120)
                + platform_q0 * w_121 + self.k_7 * w_117);
        let w_123 = platform_q2 * w_20;
        let w_124 = w_53 * platform_q0_dot - platform_q0 * w_99 - w_123;
        let w_125 = platform_q1 * w_20;
        let w_126 = w_125 + w_54 * platform_q0_dot + platform_q0 * w_98;
        let w_127 = w_20 * w_24 * (w_53 * self.k_50 + w_54 * self.k_51);
        let w_128 = a1_on_platform_z
            * (w_squared * (self.k_10 * w_124 + self.k_8 * w_126) - platform_q0 * w_127
                + w * (self.k_7 * platform_q2_dot - self.k_11 * platform_q1_dot));
        let w_129 = w_72 * w_91
            + w_47
                * (w_squared * (self.k_8 * w_113 + self.k_10 * w_114 + self.k_48 * w_115)
                    + platform_q0 * w_116 - self.k_11 * w_117) + w_73 * w_97 + w_122
            - w_74 * w_100 - w_128;
        let w_130 = platform_q1 * w_89 - w_123 - w_45 * platform_q1_dot;
        let w_131 = w_40 * platform_q1_dot;
        let w_132 = platform_q1 * w_86;
        let w_133 = w * platform_q2_dot;
        let w_134 = w_47
            * (w_squared * (self.k_8 * w_130 + self.k_10 * w_131 + self.k_48 * w_132)
                + platform_q1 * w_116 + self.k_11 * w_133);
        let w_135 = w_squared * (w_123 + w_48 * platform_q1_dot + platform_q1 * w_92);
        let w_136 = w_48 * w_39;
        let w_137 = S::from_f64(4.0) * w_25;
        let w_138 = w_50 * w_137 - S::from_f64(2.0) * w_squared * (w_20 + w_95);
        let w_139 = platform_q1 * w_138 + w_81 * platform_q1_dot;
        let w_140 = platform_q1 * w_99 - w_112 - w_53 * platform_q1_dot;
        let w_141 = platform_q0 * w_20;
        let w_142 = w_141 + w_54 * platform_q1_dot + platform_q1 * w_98;
        let w_143 = a1_on_platform_z
            * (w_squared * (self.k_10 * w_140 - self.k_8 * w_142)
                + w * (self.k_7 * platform_q3_dot + self.k_11 * platform_q0_dot)
                + platform_q1 * w_127);
        let w_144 = w_77 * w_91 + w_134 + w_83 * w_97
            + w_52
                * (self.k_7 * w_133 - self.k_10 * w_135 + self.k_50 * w_136
                    - self.k_8 * w_139) + w_84 * w_100 + w_143;
        let w_145 = w_squared * (platform_q2 * w_89 - w_125 - w_45 * platform_q2_dot);
        let w_146 = w * platform_q1_dot;
        let w_147 = w_40 * w_137 - S::from_f64(2.0) * w_squared * (w_20 + w_86);
        let w_148 = platform_q2 * w_147 + w_60 * platform_q2_dot;
        let w_149 = w_45 * w_30;
        let w_150 = w_50 * platform_q2_dot;
        let w_151 = w_125 + w_48 * platform_q2_dot + platform_q2 * w_92;
        let w_152 = platform_q2 * w_95;
        let w_153 = w_52
            * (w_squared * (self.k_8 * w_150 - self.k_10 * w_151 + self.k_49 * w_152)
                + platform_q2 * w_121 + self.k_7 * w_146);
        let w_154 = platform_q2 * w_99 - w_53 * platform_q2_dot + w_141;
        let w_155 = w_112 + w_54 * platform_q2_dot + platform_q2 * w_98;
        let w_156 = a1_on_platform_z
            * (w_squared * (self.k_10 * w_154 - self.k_8 * w_155)
                + w * (self.k_11 * platform_q3_dot - self.k_7 * platform_q0_dot)
                + platform_q2 * w_127);
        let w_157 = w_64 * w_91
            + w_47
                * (self.k_8 * w_145 + self.k_11 * w_146 - self.k_10 * w_148
                    + self.k_51 * w_149) + w_66 * w_97 + w_153 + w_68 * w_100 + w_156;
        let w_158 = w_squared * (w_45 * platform_q3_dot - w_141 - platform_q3 * w_89);
        let w_159 = w * platform_q0_dot;
        let w_160 = platform_q3 * w_147 + w_60 * platform_q3_dot;
        let w_161 = w_45 * w_26;
        let w_162 = w_squared * (w_141 + w_48 * platform_q3_dot + platform_q3 * w_92);
        let w_163 = w_48 * w_26;
        let w_164 = platform_q3 * w_138 + w_81 * platform_q3_dot;
        let w_165 = w_52
            * (self.k_7 * w_159 - self.k_10 * w_162 + self.k_50 * w_163
                - self.k_8 * w_164);
        let w_166 = platform_q3 * w_99 - w_125 - w_53 * platform_q3_dot;
        let w_167 = w_123 + w_54 * platform_q3_dot + platform_q3 * w_98;
        let w_168 = a1_on_platform_z
            * (w_squared * (self.k_10 * w_166 - self.k_8 * w_167)
                + w * (self.k_11 * platform_q2_dot + self.k_7 * platform_q1_dot)
                + platform_q3 * w_127);
        let w_169 = w_105 * w_91
            + w_47
                * (self.k_8 * w_158 + self.k_11 * w_159 + self.k_10 * w_160
                    - self.k_51 * w_161) - w_108 * w_97 - w_165 - w_109 * w_100 - w_168;
        let w_170 = S::from_f64(2.0)
            * (w_111
                + (platform_q0_dot * w_129 + platform_q1_dot * w_144
                    + platform_q2_dot * w_157 - platform_q3_dot * w_169) / w_56);
        let w_171 = w_170
            + (platform_x_dot * w_91 + platform_y_dot * w_97 + platform_z_dot * w_100)
                / w_56
            - w_101
                * ((w_47 * platform_x_dot + w_52 * platform_y_dot
                    + a1_on_platform_z * platform_z_dot) / w_56_squared);
        let w_172 = self.w * t;
        let w_173 = self.k_12 + w_172;
        let w_174 = self.k_25 + w_172;
        let w_175 = self.k_38 + w_172;
        let (
            [sin_w_172,
            sin_w_173,
            sin_w_174,
            sin_w_175,
            ],
            [cos_w_172,
            cos_w_173,
            cos_w_174,
            cos_w_175,
            ],
        ) = S::sin_cos_each([w_172, w_173, w_174, w_175]);
        let minus_k_lambda_a1_leg_platform_q3 = w_57 * w_110 / w_56
            + mass_platform_q3_platform_q0 * l_lambda_a1_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_a1_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_a1_leg_platform_q2;
        let minus_l_lambda_a1_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_a1_leg_platform_q3;
        let a1_leg_by_platform_z = a1_on_platform_z * sqrt_w_56 / w_56;
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
            - (sqrt_w_56 * w_171 + sin_w_172 * self.k_54)
            - rhs_platform_q0 * l_lambda_a1_leg_platform_q0
            - l_lambda_a1_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_a1_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_a1_leg_platform_z
            + minus_l_lambda_a1_leg_lambda_platform_norm * rhs_lambda_platform_norm;
        let w_176 = platform_x - self.k_13 - w_42 * self.k_14 + w_46 * self.k_15;
        let w_177 = platform_y - self.k_16 + w_49 * self.k_17 - w_51 * self.k_18;
        let w_178 = w_53 * self.k_17 + w_54 * self.k_15;
        let a2_on_platform_z = w * w_178 + platform_z;
        let w_179 = w_176 * w_176 + w_177 * w_177 + a2_on_platform_z * a2_on_platform_z;
        let sqrt_w_179 = w_179.sqrt();
        let w_180 = S::from_f64(2.0) * sqrt_w_179;
        let w_181 = w_58 * self.k_18 - w_61 * self.k_17 - w_63 * self.k_15;
        let w_182 = w_squared * (w_50 * self.k_15 - w_48 * self.k_17);
        let w_183 = platform_q2 * w_182 + w_58 * self.k_14;
        let w_184 = w_squared * w_178;
        let w_185 = w * (platform_q3 * self.k_18 - platform_q0 * self.k_14)
            - platform_q2 * w_184;
        let w_186 = w_176 * w_181 + w_177 * w_183 + a2_on_platform_z * w_185;
        let w_187 = w_squared * (w_40 * self.k_17 - w_45 * self.k_15);
        let w_188 = platform_q0 * w_187 - w_71 * self.k_18;
        let w_189 = platform_q0 * w_182 + w_71 * self.k_14;
        let w_190 = platform_q0 * w_184
            + w * (platform_q2 * self.k_14 - platform_q1 * self.k_18);
        let w_191 = w_176 * w_188 + w_177 * w_189 - a2_on_platform_z * w_190;
        let a2_leg_by_platform_q0 = w_191 * w_180 / w_179;
        let l_lambda_a2_leg_platform_q0 = a2_leg_by_platform_q0 * inverse_platform_q0;
        let w_192 = platform_q1 * w_187 + w_76 * self.k_18;
        let w_193 = w_76 * self.k_14 - w_79 * self.k_17 - w_82 * self.k_15;
        let w_194 = w * (platform_q3 * self.k_14 + platform_q0 * self.k_18)
            - platform_q1 * w_184;
        let w_195 = w_176 * w_192 + w_177 * w_193 + a2_on_platform_z * w_194;
        let k_lambda_a2_leg_platform_q1 = w_180 * w_195 / w_179
            - mass_platform_q1_platform_q0 * l_lambda_a2_leg_platform_q0;
        let l_lambda_a2_leg_platform_q1 = inverse_platform_q1
            * k_lambda_a2_leg_platform_q1;
        let k_lambda_a2_leg_platform_q2 = w_180 * w_186 / w_179
            - mass_platform_q2_platform_q0 * l_lambda_a2_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_a2_leg_platform_q1;
        let l_lambda_a2_leg_platform_q2 = inverse_platform_q2
            * k_lambda_a2_leg_platform_q2;
        let w_196 = platform_x_dot + w_87 * self.k_55 - w_88 * self.k_56
            - self.k_15 * w_90;
        let w_197 = platform_y_dot + self.k_17 * w_93 - w_94 * self.k_55
            + w_96 * self.k_56;
        let w_198 = w * (self.k_15 * w_98 - self.k_17 * w_99)
            - w_squared * w_20 * (w_53 * self.k_55 + w_54 * self.k_56) + platform_z_dot;
        let w_199 = w_176 * w_196 + w_177 * w_197 + a2_on_platform_z * w_198;
        let w_200 = w_102 * self.k_18 + w_103 * self.k_17 + w_104 * self.k_15;
        let w_201 = w_102 * self.k_14 - w_106 * self.k_17 - w_107 * self.k_15;
        let w_202 = w * (platform_q2 * self.k_18 + platform_q1 * self.k_14)
            - platform_q3 * w_184;
        let w_203 = w_176 * w_200 - w_177 * w_201 - a2_on_platform_z * w_202;
        let w_179_squared = w_179 * w_179;
        let w_204 = w_199
            * ((w_203 * platform_q3_dot - w_191 * platform_q0_dot
                - w_195 * platform_q1_dot - w_186 * platform_q2_dot) / w_179_squared);
        let w_205 = w_20 * w_24 * (w_45 * self.k_58 - w_40 * self.k_57);
        let w_206 = w_20 * w_24 * (w_48 * self.k_57 - w_50 * self.k_58);
        let w_207 = w_177
            * (w_squared * (self.k_15 * w_118 - self.k_17 * w_119 + w_120 * self.k_56)
                + platform_q0 * w_206 + self.k_14 * w_117);
        let w_208 = w_20 * w_24 * (w_53 * self.k_57 + w_54 * self.k_58);
        let w_209 = a2_on_platform_z
            * (w_squared * (self.k_17 * w_124 + self.k_15 * w_126) - platform_q0 * w_208
                + w * (self.k_14 * platform_q2_dot - self.k_18 * platform_q1_dot));
        let w_210 = w_188 * w_196
            + w_176
                * (w_squared
                    * (self.k_15 * w_113 + self.k_17 * w_114 + w_115 * self.k_55)
                    + platform_q0 * w_205 - self.k_18 * w_117) + w_189 * w_197 + w_207
            - w_190 * w_198 - w_209;
        let w_211 = w_176
            * (w_squared * (self.k_15 * w_130 + self.k_17 * w_131 + w_132 * self.k_55)
                + platform_q1 * w_205 + self.k_18 * w_133);
        let w_212 = a2_on_platform_z
            * (w_squared * (self.k_17 * w_140 - self.k_15 * w_142)
                + w * (self.k_14 * platform_q3_dot + self.k_18 * platform_q0_dot)
                + platform_q1 * w_208);
        let w_213 = w_192 * w_196 + w_211 + w_193 * w_197
            + w_177
                * (self.k_14 * w_133 - self.k_17 * w_135 + w_136 * self.k_57
                    - self.k_15 * w_139) + w_194 * w_198 + w_212;
        let w_214 = w_177
            * (w_squared * (self.k_15 * w_150 - self.k_17 * w_151 + w_152 * self.k_56)
                + platform_q2 * w_206 + self.k_14 * w_146);
        let w_215 = a2_on_platform_z
            * (w_squared * (self.k_17 * w_154 - self.k_15 * w_155)
                + w * (self.k_18 * platform_q3_dot - self.k_14 * platform_q0_dot)
                + platform_q2 * w_208);
        let w_216 = w_181 * w_196
            + w_176
                * (self.k_15 * w_145 + self.k_18 * w_146 - self.k_17 * w_148
                    + w_149 * self.k_58) + w_183 * w_197 + w_214 + w_185 * w_198 + w_215;
        let w_217 = w_177
            * (self.k_14 * w_159 - self.k_17 * w_162 + w_163 * self.k_57
                - self.k_15 * w_164);
        let w_218 = a2_on_platform_z
            * (w_squared * (self.k_17 * w_166 - self.k_15 * w_167)
                + w * (self.k_18 * platform_q2_dot + self.k_14 * platform_q1_dot)
                + platform_q3 * w_208);
        let w_219 = w_200 * w_196
            + w_176
                * (self.k_15 * w_158 + self.k_18 * w_159 + self.k_17 * w_160
                    - w_161 * self.k_58) - w_201 * w_197 - w_217 - w_202 * w_198 - w_218;
        let w_220 = S::from_f64(2.0)
            * (w_204
                + (platform_q0_dot * w_210 + platform_q1_dot * w_213
                    + platform_q2_dot * w_216 - platform_q3_dot * w_219) / w_179);
        let w_221 = w_220
            + (platform_x_dot * w_196 + platform_y_dot * w_197 + platform_z_dot * w_198)
                / w_179
            - w_199
                * ((w_176 * platform_x_dot + w_177 * platform_y_dot
                    + a2_on_platform_z * platform_z_dot) / w_179_squared);
        let w_222 = sin_w_172 * self.k_52;
        let w_223 = self.k_53 * sin_w_173;
        let minus_k_lambda_a2_leg_platform_q3 = w_180 * w_203 / w_179
            + mass_platform_q3_platform_q0 * l_lambda_a2_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_a2_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_a2_leg_platform_q2;
        let minus_l_lambda_a2_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_a2_leg_platform_q3;
        let a2_leg_by_platform_z = a2_on_platform_z * sqrt_w_179 / w_179;
        let l_lambda_a2_leg_platform_z = a2_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_a2_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_a2_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_a2_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_a2_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_a2_leg_platform_q2;
        let minus_l_lambda_a2_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_a2_leg_lambda_platform_norm;
        let a1_leg_by_platform_x = w_47 * sqrt_w_56 / w_56;
        let l_lambda_a1_leg_platform_x = a1_leg_by_platform_x * self.inverse_platform_x;
        let a1_leg_by_platform_y = w_52 * sqrt_w_56 / w_56;
        let l_lambda_a1_leg_platform_y = a1_leg_by_platform_y * self.inverse_platform_x;
        let w_224 = a1_leg_by_platform_q0 * l_lambda_a1_leg_platform_q0
            + k_lambda_a1_leg_platform_q1 * l_lambda_a1_leg_platform_q1
            + k_lambda_a1_leg_platform_q2 * l_lambda_a1_leg_platform_q2
            + minus_k_lambda_a1_leg_platform_q3 * minus_l_lambda_a1_leg_platform_q3
            + a1_leg_by_platform_x * l_lambda_a1_leg_platform_x
            + a1_leg_by_platform_y * l_lambda_a1_leg_platform_y
            + a1_leg_by_platform_z * l_lambda_a1_leg_platform_z;
        let pivot_lambda_a1_leg = k_lambda_a1_leg_lambda_platform_norm
            * minus_l_lambda_a1_leg_lambda_platform_norm - w_224;
        let inverse_lambda_a1_leg = S::from_f64(1.0) / pivot_lambda_a1_leg;
        let a2_leg_by_platform_x = w_176 * sqrt_w_179 / w_179;
        let l_lambda_a2_leg_platform_x = a2_leg_by_platform_x * self.inverse_platform_x;
        let a2_leg_by_platform_y = w_177 * sqrt_w_179 / w_179;
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
            - (sqrt_w_179 * w_221 + w_222 - w_223)
            - rhs_platform_q0 * l_lambda_a2_leg_platform_q0
            - l_lambda_a2_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_a2_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_a2_leg_platform_z
            + minus_l_lambda_a2_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_a2_leg_lambda_a1_leg * rhs_lambda_a1_leg;
        let w_225 = platform_x - self.k_19 - w_42 * self.k_20 + w_46 * self.k_21;
        let w_226 = platform_y - self.k_22 + w_49 * self.k_23 - w_51 * self.k_24;
        let w_227 = w_53 * self.k_23 + w_54 * self.k_21;
        let b1_on_platform_z = w * w_227 + platform_z;
        let w_228 = w_225 * w_225 + w_226 * w_226 + b1_on_platform_z * b1_on_platform_z;
        let sqrt_w_228 = w_228.sqrt();
        let w_229 = S::from_f64(2.0) * sqrt_w_228;
        let w_230 = w_58 * self.k_24 - w_61 * self.k_23 - w_63 * self.k_21;
        let w_231 = w_squared * (w_50 * self.k_21 - w_48 * self.k_23);
        let w_232 = platform_q2 * w_231 + w_58 * self.k_20;
        let w_233 = w_squared * w_227;
        let w_234 = w * (platform_q3 * self.k_24 - platform_q0 * self.k_20)
            - platform_q2 * w_233;
        let w_235 = w_225 * w_230 + w_226 * w_232 + b1_on_platform_z * w_234;
        let w_236 = w_squared * (w_40 * self.k_23 - w_45 * self.k_21);
        let w_237 = platform_q0 * w_236 - w_71 * self.k_24;
        let w_238 = platform_q0 * w_231 + w_71 * self.k_20;
        let w_239 = platform_q0 * w_233
            + w * (platform_q2 * self.k_20 - platform_q1 * self.k_24);
        let w_240 = w_225 * w_237 + w_226 * w_238 - b1_on_platform_z * w_239;
        let b1_leg_by_platform_q0 = w_240 * w_229 / w_228;
        let l_lambda_b1_leg_platform_q0 = b1_leg_by_platform_q0 * inverse_platform_q0;
        let w_241 = platform_q1 * w_236 + w_76 * self.k_24;
        let w_242 = w_76 * self.k_20 - w_79 * self.k_23 - w_82 * self.k_21;
        let w_243 = w * (platform_q3 * self.k_20 + platform_q0 * self.k_24)
            - platform_q1 * w_233;
        let w_244 = w_225 * w_241 + w_226 * w_242 + b1_on_platform_z * w_243;
        let k_lambda_b1_leg_platform_q1 = w_229 * w_244 / w_228
            - mass_platform_q1_platform_q0 * l_lambda_b1_leg_platform_q0;
        let l_lambda_b1_leg_platform_q1 = inverse_platform_q1
            * k_lambda_b1_leg_platform_q1;
        let k_lambda_b1_leg_platform_q2 = w_229 * w_235 / w_228
            - mass_platform_q2_platform_q0 * l_lambda_b1_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_b1_leg_platform_q1;
        let l_lambda_b1_leg_platform_q2 = inverse_platform_q2
            * k_lambda_b1_leg_platform_q2;
        let w_245 = platform_x_dot + w_87 * self.k_59 - w_88 * self.k_60
            - self.k_21 * w_90;
        let w_246 = platform_y_dot + self.k_23 * w_93 - w_94 * self.k_59
            + w_96 * self.k_60;
        let w_247 = w * (self.k_21 * w_98 - self.k_23 * w_99)
            - w_squared * w_20 * (w_53 * self.k_59 + w_54 * self.k_60) + platform_z_dot;
        let w_248 = w_225 * w_245 + w_226 * w_246 + b1_on_platform_z * w_247;
        let w_249 = w_102 * self.k_24 + w_103 * self.k_23 + w_104 * self.k_21;
        let w_250 = w_102 * self.k_20 - w_106 * self.k_23 - w_107 * self.k_21;
        let w_251 = w * (platform_q2 * self.k_24 + platform_q1 * self.k_20)
            - platform_q3 * w_233;
        let w_252 = w_225 * w_249 - w_226 * w_250 - b1_on_platform_z * w_251;
        let w_228_squared = w_228 * w_228;
        let w_253 = w_248
            * ((w_252 * platform_q3_dot - w_240 * platform_q0_dot
                - w_244 * platform_q1_dot - w_235 * platform_q2_dot) / w_228_squared);
        let w_254 = w_20 * w_24 * (w_45 * self.k_62 - w_40 * self.k_61);
        let w_255 = w_20 * w_24 * (w_48 * self.k_61 - w_50 * self.k_62);
        let w_256 = w_226
            * (w_squared * (self.k_21 * w_118 - self.k_23 * w_119 + w_120 * self.k_60)
                + platform_q0 * w_255 + self.k_20 * w_117);
        let w_257 = w_20 * w_24 * (w_53 * self.k_61 + w_54 * self.k_62);
        let w_258 = b1_on_platform_z
            * (w_squared * (self.k_23 * w_124 + self.k_21 * w_126) - platform_q0 * w_257
                + w * (self.k_20 * platform_q2_dot - self.k_24 * platform_q1_dot));
        let w_259 = w_237 * w_245
            + w_225
                * (w_squared
                    * (self.k_21 * w_113 + self.k_23 * w_114 + w_115 * self.k_59)
                    + platform_q0 * w_254 - self.k_24 * w_117) + w_238 * w_246 + w_256
            - w_239 * w_247 - w_258;
        let w_260 = w_225
            * (w_squared * (self.k_21 * w_130 + self.k_23 * w_131 + w_132 * self.k_59)
                + platform_q1 * w_254 + self.k_24 * w_133);
        let w_261 = b1_on_platform_z
            * (w_squared * (self.k_23 * w_140 - self.k_21 * w_142)
                + w * (self.k_20 * platform_q3_dot + self.k_24 * platform_q0_dot)
                + platform_q1 * w_257);
        let w_262 = w_241 * w_245 + w_260 + w_242 * w_246
            + w_226
                * (self.k_20 * w_133 - self.k_23 * w_135 + w_136 * self.k_61
                    - self.k_21 * w_139) + w_243 * w_247 + w_261;
        let w_263 = w_226
            * (w_squared * (self.k_21 * w_150 - self.k_23 * w_151 + w_152 * self.k_60)
                + platform_q2 * w_255 + self.k_20 * w_146);
        let w_264 = b1_on_platform_z
            * (w_squared * (self.k_23 * w_154 - self.k_21 * w_155)
                + w * (self.k_24 * platform_q3_dot - self.k_20 * platform_q0_dot)
                + platform_q2 * w_257);
        let w_265 = w_230 * w_245
            + w_225
                * (self.k_21 * w_145 + self.k_24 * w_146 - self.k_23 * w_148
                    + w_149 * self.k_62) + w_232 * w_246 + w_263 + w_234 * w_247 + w_264;
        let w_266 = w_226
            * (self.k_20 * w_159 - self.k_23 * w_162 + w_163 * self.k_61
                - self.k_21 * w_164);
        let w_267 = b1_on_platform_z
            * (w_squared * (self.k_23 * w_166 - self.k_21 * w_167)
                + w * (self.k_24 * platform_q2_dot + self.k_20 * platform_q1_dot)
                + platform_q3 * w_257);
        let w_268 = w_249 * w_245
            + w_225
                * (self.k_21 * w_158 + self.k_24 * w_159 + self.k_23 * w_160
                    - w_161 * self.k_62) - w_250 * w_246 - w_266 - w_251 * w_247 - w_267;
        let w_269 = S::from_f64(2.0)
            * (w_253
                + (platform_q0_dot * w_259 + platform_q1_dot * w_262
                    + platform_q2_dot * w_265 - platform_q3_dot * w_268) / w_228);
        let w_270 = w_269
            + (platform_x_dot * w_245 + platform_y_dot * w_246 + platform_z_dot * w_247)
                / w_228
            - w_248
                * ((w_225 * platform_x_dot + w_226 * platform_y_dot
                    + b1_on_platform_z * platform_z_dot) / w_228_squared);
        let minus_k_lambda_b1_leg_platform_q3 = w_229 * w_252 / w_228
            + mass_platform_q3_platform_q0 * l_lambda_b1_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_b1_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_b1_leg_platform_q2;
        let minus_l_lambda_b1_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_b1_leg_platform_q3;
        let b1_leg_by_platform_z = b1_on_platform_z * sqrt_w_228 / w_228;
        let l_lambda_b1_leg_platform_z = b1_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_b1_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_b1_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_b1_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_b1_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_b1_leg_platform_q2;
        let minus_l_lambda_b1_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_b1_leg_lambda_platform_norm;
        let b1_leg_by_platform_x = w_225 * sqrt_w_228 / w_228;
        let l_lambda_b1_leg_platform_x = b1_leg_by_platform_x * self.inverse_platform_x;
        let b1_leg_by_platform_y = w_226 * sqrt_w_228 / w_228;
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
        let w_271 = a2_leg_by_platform_q0 * l_lambda_a2_leg_platform_q0
            + k_lambda_a2_leg_platform_q1 * l_lambda_a2_leg_platform_q1
            + k_lambda_a2_leg_platform_q2 * l_lambda_a2_leg_platform_q2
            + minus_k_lambda_a2_leg_platform_q3 * minus_l_lambda_a2_leg_platform_q3
            + a2_leg_by_platform_x * l_lambda_a2_leg_platform_x
            + a2_leg_by_platform_y * l_lambda_a2_leg_platform_y
            + a2_leg_by_platform_z * l_lambda_a2_leg_platform_z;
        let pivot_lambda_a2_leg = k_lambda_a2_leg_lambda_platform_norm
            * minus_l_lambda_a2_leg_lambda_platform_norm - w_271
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
            - (sqrt_w_228 * w_270 + w_222 + w_223)
            - rhs_platform_q0 * l_lambda_b1_leg_platform_q0
            - l_lambda_b1_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_b1_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_b1_leg_platform_z
            + minus_l_lambda_b1_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_b1_leg_lambda_a1_leg * rhs_lambda_a1_leg
            - l_lambda_b1_leg_lambda_a2_leg * rhs_lambda_a2_leg;
        let w_272 = platform_x - self.k_26 - w_42 * self.k_27 + w_46 * self.k_28;
        let w_273 = platform_y - self.k_29 + w_49 * self.k_30 - w_51 * self.k_31;
        let w_274 = w_53 * self.k_30 + w_54 * self.k_28;
        let b2_on_platform_z = w * w_274 + platform_z;
        let w_275 = w_272 * w_272 + w_273 * w_273 + b2_on_platform_z * b2_on_platform_z;
        let sqrt_w_275 = w_275.sqrt();
        let w_276 = S::from_f64(2.0) * sqrt_w_275;
        let w_277 = w_58 * self.k_31 - w_61 * self.k_30 - w_63 * self.k_28;
        let w_278 = w_squared * (w_50 * self.k_28 - w_48 * self.k_30);
        let w_279 = platform_q2 * w_278 + w_58 * self.k_27;
        let w_280 = w_squared * w_274;
        let w_281 = w * (platform_q3 * self.k_31 - platform_q0 * self.k_27)
            - platform_q2 * w_280;
        let w_282 = w_272 * w_277 + w_273 * w_279 + b2_on_platform_z * w_281;
        let w_283 = w_squared * (w_40 * self.k_30 - w_45 * self.k_28);
        let w_284 = platform_q0 * w_283 - w_71 * self.k_31;
        let w_285 = platform_q0 * w_278 + w_71 * self.k_27;
        let w_286 = platform_q0 * w_280
            + w * (platform_q2 * self.k_27 - platform_q1 * self.k_31);
        let w_287 = w_272 * w_284 + w_273 * w_285 - b2_on_platform_z * w_286;
        let b2_leg_by_platform_q0 = w_287 * w_276 / w_275;
        let l_lambda_b2_leg_platform_q0 = b2_leg_by_platform_q0 * inverse_platform_q0;
        let w_288 = platform_q1 * w_283 + w_76 * self.k_31;
        let w_289 = w_76 * self.k_27 - w_79 * self.k_30 - w_82 * self.k_28;
        let w_290 = w * (platform_q3 * self.k_27 + platform_q0 * self.k_31)
            - platform_q1 * w_280;
        let w_291 = w_272 * w_288 + w_273 * w_289 + b2_on_platform_z * w_290;
        let k_lambda_b2_leg_platform_q1 = w_276 * w_291 / w_275
            - mass_platform_q1_platform_q0 * l_lambda_b2_leg_platform_q0;
        let l_lambda_b2_leg_platform_q1 = inverse_platform_q1
            * k_lambda_b2_leg_platform_q1;
        let k_lambda_b2_leg_platform_q2 = w_276 * w_282 / w_275
            - mass_platform_q2_platform_q0 * l_lambda_b2_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_b2_leg_platform_q1;
        let l_lambda_b2_leg_platform_q2 = inverse_platform_q2
            * k_lambda_b2_leg_platform_q2;
        let w_292 = platform_x_dot + w_87 * self.k_63 - w_88 * self.k_64
            - self.k_28 * w_90;
        let w_293 = platform_y_dot + self.k_30 * w_93 - w_94 * self.k_63
            + w_96 * self.k_64;
        let w_294 = w * (self.k_28 * w_98 - self.k_30 * w_99)
            - w_squared * w_20 * (w_53 * self.k_63 + w_54 * self.k_64) + platform_z_dot;
        let w_295 = w_272 * w_292 + w_273 * w_293 + b2_on_platform_z * w_294;
        let w_296 = w_102 * self.k_31 + w_103 * self.k_30 + w_104 * self.k_28;
        let w_297 = w_102 * self.k_27 - w_106 * self.k_30 - w_107 * self.k_28;
        let w_298 = w * (platform_q2 * self.k_31 + platform_q1 * self.k_27)
            - platform_q3 * w_280;
        let w_299 = w_272 * w_296 - w_273 * w_297 - b2_on_platform_z * w_298;
        let w_275_squared = w_275 * w_275;
        let w_300 = w_295
            * ((w_299 * platform_q3_dot - w_287 * platform_q0_dot
                - w_291 * platform_q1_dot - w_282 * platform_q2_dot) / w_275_squared);
        let w_301 = w_20 * w_24 * (w_45 * self.k_66 - w_40 * self.k_65);
        let w_302 = w_20 * w_24 * (w_48 * self.k_65 - w_50 * self.k_66);
        let w_303 = w_273
            * (w_squared * (self.k_28 * w_118 - self.k_30 * w_119 + w_120 * self.k_64)
                + platform_q0 * w_302 + self.k_27 * w_117);
        let w_304 = w_20 * w_24 * (w_53 * self.k_65 + w_54 * self.k_66);
        let w_305 = b2_on_platform_z
            * (w_squared * (self.k_30 * w_124 + self.k_28 * w_126) - platform_q0 * w_304
                + w * (self.k_27 * platform_q2_dot - self.k_31 * platform_q1_dot));
        let w_306 = w_284 * w_292
            + w_272
                * (w_squared
                    * (self.k_28 * w_113 + self.k_30 * w_114 + w_115 * self.k_63)
                    + platform_q0 * w_301 - self.k_31 * w_117) + w_285 * w_293 + w_303
            - w_286 * w_294 - w_305;
        let w_307 = w_272
            * (w_squared * (self.k_28 * w_130 + self.k_30 * w_131 + w_132 * self.k_63)
                + platform_q1 * w_301 + self.k_31 * w_133);
        let w_308 = b2_on_platform_z
            * (w_squared * (self.k_30 * w_140 - self.k_28 * w_142)
                + w * (self.k_27 * platform_q3_dot + self.k_31 * platform_q0_dot)
                + platform_q1 * w_304);
        let w_309 = w_288 * w_292 + w_307 + w_289 * w_293
            + w_273
                * (self.k_27 * w_133 - self.k_30 * w_135 + w_136 * self.k_65
                    - self.k_28 * w_139) + w_290 * w_294 + w_308;
        let w_310 = w_273
            * (w_squared * (self.k_28 * w_150 - self.k_30 * w_151 + w_152 * self.k_64)
                + platform_q2 * w_302 + self.k_27 * w_146);
        let w_311 = b2_on_platform_z
            * (w_squared * (self.k_30 * w_154 - self.k_28 * w_155)
                + w * (self.k_31 * platform_q3_dot - self.k_27 * platform_q0_dot)
                + platform_q2 * w_304);
        let w_312 = w_277 * w_292
            + w_272
                * (self.k_28 * w_145 + self.k_31 * w_146 - self.k_30 * w_148
                    + w_149 * self.k_66) + w_279 * w_293 + w_310 + w_281 * w_294 + w_311;
        let w_313 = w_273
            * (self.k_27 * w_159 - self.k_30 * w_162 + w_163 * self.k_65
                - self.k_28 * w_164);
        let w_314 = b2_on_platform_z
            * (w_squared * (self.k_30 * w_166 - self.k_28 * w_167)
                + w * (self.k_31 * platform_q2_dot + self.k_27 * platform_q1_dot)
                + platform_q3 * w_304);
        let w_315 = w_296 * w_292
            + w_272
                * (self.k_28 * w_158 + self.k_31 * w_159 + self.k_30 * w_160
                    - w_161 * self.k_66) - w_297 * w_293 - w_313 - w_298 * w_294 - w_314;
        let w_316 = S::from_f64(2.0)
            * (w_300
                + (platform_q0_dot * w_306 + platform_q1_dot * w_309
                    + platform_q2_dot * w_312 - platform_q3_dot * w_315) / w_275);
        let w_317 = w_316
            + (platform_x_dot * w_292 + platform_y_dot * w_293 + platform_z_dot * w_294)
                / w_275
            - w_295
                * ((w_272 * platform_x_dot + w_273 * platform_y_dot
                    + b2_on_platform_z * platform_z_dot) / w_275_squared);
        let w_318 = self.k_53 * sin_w_174;
        let minus_k_lambda_b2_leg_platform_q3 = w_276 * w_299 / w_275
            + mass_platform_q3_platform_q0 * l_lambda_b2_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_b2_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_b2_leg_platform_q2;
        let minus_l_lambda_b2_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_b2_leg_platform_q3;
        let b2_leg_by_platform_z = b2_on_platform_z * sqrt_w_275 / w_275;
        let l_lambda_b2_leg_platform_z = b2_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_b2_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_b2_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_b2_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_b2_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_b2_leg_platform_q2;
        let minus_l_lambda_b2_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_b2_leg_lambda_platform_norm;
        let b2_leg_by_platform_x = w_272 * sqrt_w_275 / w_275;
        let l_lambda_b2_leg_platform_x = b2_leg_by_platform_x * self.inverse_platform_x;
        let b2_leg_by_platform_y = w_273 * sqrt_w_275 / w_275;
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
        let w_319 = b1_leg_by_platform_q0 * l_lambda_b1_leg_platform_q0
            + k_lambda_b1_leg_platform_q1 * l_lambda_b1_leg_platform_q1
            + k_lambda_b1_leg_platform_q2 * l_lambda_b1_leg_platform_q2
            + minus_k_lambda_b1_leg_platform_q3 * minus_l_lambda_b1_leg_platform_q3
            + b1_leg_by_platform_x * l_lambda_b1_leg_platform_x
            + b1_leg_by_platform_y * l_lambda_b1_leg_platform_y
            + b1_leg_by_platform_z * l_lambda_b1_leg_platform_z;
        let pivot_lambda_b1_leg = k_lambda_b1_leg_lambda_platform_norm
            * minus_l_lambda_b1_leg_lambda_platform_norm - w_319
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
            - (sqrt_w_275 * w_317 + w_222 - w_318)
            - rhs_platform_q0 * l_lambda_b2_leg_platform_q0
            - l_lambda_b2_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_b2_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_b2_leg_platform_z
            + minus_l_lambda_b2_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_b2_leg_lambda_a1_leg * rhs_lambda_a1_leg
            - l_lambda_b2_leg_lambda_a2_leg * rhs_lambda_a2_leg
            - l_lambda_b2_leg_lambda_b1_leg * rhs_lambda_b1_leg;
        let w_320 = platform_x - self.k_32 - w_42 * self.k_33 + w_46 * self.k_34;
        let w_321 = platform_y - self.k_35 + w_49 * self.k_36 - w_51 * self.k_37;
        let w_322 = w_53 * self.k_36 + w_54 * self.k_34;
        let c1_on_platform_z = w * w_322 + platform_z;
        let w_323 = w_320 * w_320 + w_321 * w_321 + c1_on_platform_z * c1_on_platform_z;
        let sqrt_w_323 = w_323.sqrt();
        let w_324 = S::from_f64(2.0) * sqrt_w_323;
        let w_325 = w_58 * self.k_37 - w_61 * self.k_36 - w_63 * self.k_34;
        let w_326 = w_squared * (w_50 * self.k_34 - w_48 * self.k_36);
        let w_327 = platform_q2 * w_326 + w_58 * self.k_33;
        let w_328 = w_squared * w_322;
        let w_329 = w * (platform_q3 * self.k_37 - platform_q0 * self.k_33)
            - platform_q2 * w_328;
        let w_330 = w_320 * w_325 + w_321 * w_327 + c1_on_platform_z * w_329;
        let w_331 = w_squared * (w_40 * self.k_36 - w_45 * self.k_34);
        let w_332 = platform_q0 * w_331 - w_71 * self.k_37;
        let w_333 = platform_q0 * w_326 + w_71 * self.k_33;
        let w_334 = platform_q0 * w_328
            + w * (platform_q2 * self.k_33 - platform_q1 * self.k_37);
        let w_335 = w_320 * w_332 + w_321 * w_333 - c1_on_platform_z * w_334;
        let c1_leg_by_platform_q0 = w_335 * w_324 / w_323;
        let l_lambda_c1_leg_platform_q0 = c1_leg_by_platform_q0 * inverse_platform_q0;
        let w_336 = platform_q1 * w_331 + w_76 * self.k_37;
        let w_337 = w_76 * self.k_33 - w_79 * self.k_36 - w_82 * self.k_34;
        let w_338 = w * (platform_q3 * self.k_33 + platform_q0 * self.k_37)
            - platform_q1 * w_328;
        let w_339 = w_320 * w_336 + w_321 * w_337 + c1_on_platform_z * w_338;
        let k_lambda_c1_leg_platform_q1 = w_324 * w_339 / w_323
            - mass_platform_q1_platform_q0 * l_lambda_c1_leg_platform_q0;
        let l_lambda_c1_leg_platform_q1 = inverse_platform_q1
            * k_lambda_c1_leg_platform_q1;
        let k_lambda_c1_leg_platform_q2 = w_324 * w_330 / w_323
            - mass_platform_q2_platform_q0 * l_lambda_c1_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_c1_leg_platform_q1;
        let l_lambda_c1_leg_platform_q2 = inverse_platform_q2
            * k_lambda_c1_leg_platform_q2;
        let w_340 = platform_x_dot + w_87 * self.k_67 - w_88 * self.k_68
            - self.k_34 * w_90;
        let w_341 = platform_y_dot + self.k_36 * w_93 - w_94 * self.k_67
            + w_96 * self.k_68;
        let w_342 = w * (self.k_34 * w_98 - self.k_36 * w_99)
            - w_squared * w_20 * (w_53 * self.k_67 + w_54 * self.k_68) + platform_z_dot;
        let w_343 = w_320 * w_340 + w_321 * w_341 + c1_on_platform_z * w_342;
        let w_344 = w_102 * self.k_37 + w_103 * self.k_36 + w_104 * self.k_34;
        let w_345 = w_102 * self.k_33 - w_106 * self.k_36 - w_107 * self.k_34;
        let w_346 = w * (platform_q2 * self.k_37 + platform_q1 * self.k_33)
            - platform_q3 * w_328;
        let w_347 = w_320 * w_344 - w_321 * w_345 - c1_on_platform_z * w_346;
        let w_323_squared = w_323 * w_323;
        let w_348 = w_343
            * ((w_347 * platform_q3_dot - w_335 * platform_q0_dot
                - w_339 * platform_q1_dot - w_330 * platform_q2_dot) / w_323_squared);
        let w_349 = w_20 * w_24 * (w_45 * self.k_70 - w_40 * self.k_69);
        let w_350 = w_20 * w_24 * (w_48 * self.k_69 - w_50 * self.k_70);
        let w_351 = w_321
            * (w_squared * (self.k_34 * w_118 - self.k_36 * w_119 + w_120 * self.k_68)
                + platform_q0 * w_350 + self.k_33 * w_117);
        let w_352 = w_20 * w_24 * (w_53 * self.k_69 + w_54 * self.k_70);
        let w_353 = c1_on_platform_z
            * (w_squared * (self.k_36 * w_124 + self.k_34 * w_126) - platform_q0 * w_352
                + w * (self.k_33 * platform_q2_dot - self.k_37 * platform_q1_dot));
        let w_354 = w_332 * w_340
            + w_320
                * (w_squared
                    * (self.k_34 * w_113 + self.k_36 * w_114 + w_115 * self.k_67)
                    + platform_q0 * w_349 - self.k_37 * w_117) + w_333 * w_341 + w_351
            - w_334 * w_342 - w_353;
        let w_355 = w_320
            * (w_squared * (self.k_34 * w_130 + self.k_36 * w_131 + w_132 * self.k_67)
                + platform_q1 * w_349 + self.k_37 * w_133);
        let w_356 = c1_on_platform_z
            * (w_squared * (self.k_36 * w_140 - self.k_34 * w_142)
                + w * (self.k_33 * platform_q3_dot + self.k_37 * platform_q0_dot)
                + platform_q1 * w_352);
        let w_357 = w_336 * w_340 + w_355 + w_337 * w_341
            + w_321
                * (self.k_33 * w_133 - self.k_36 * w_135 + w_136 * self.k_69
                    - self.k_34 * w_139) + w_338 * w_342 + w_356;
        let w_358 = w_321
            * (w_squared * (self.k_34 * w_150 - self.k_36 * w_151 + w_152 * self.k_68)
                + platform_q2 * w_350 + self.k_33 * w_146);
        let w_359 = c1_on_platform_z
            * (w_squared * (self.k_36 * w_154 - self.k_34 * w_155)
                + w * (self.k_37 * platform_q3_dot - self.k_33 * platform_q0_dot)
                + platform_q2 * w_352);
        let w_360 = w_325 * w_340
            + w_320
                * (self.k_34 * w_145 + self.k_37 * w_146 - self.k_36 * w_148
                    + w_149 * self.k_70) + w_327 * w_341 + w_358 + w_329 * w_342 + w_359;
        let w_361 = w_321
            * (self.k_33 * w_159 - self.k_36 * w_162 + w_163 * self.k_69
                - self.k_34 * w_164);
        let w_362 = c1_on_platform_z
            * (w_squared * (self.k_36 * w_166 - self.k_34 * w_167)
                + w * (self.k_37 * platform_q2_dot + self.k_33 * platform_q1_dot)
                + platform_q3 * w_352);
        let w_363 = w_344 * w_340
            + w_320
                * (self.k_34 * w_158 + self.k_37 * w_159 + self.k_36 * w_160
                    - w_161 * self.k_70) - w_345 * w_341 - w_361 - w_346 * w_342 - w_362;
        let w_364 = S::from_f64(2.0)
            * (w_348
                + (platform_q0_dot * w_354 + platform_q1_dot * w_357
                    + platform_q2_dot * w_360 - platform_q3_dot * w_363) / w_323);
        let w_365 = w_364
            + (platform_x_dot * w_340 + platform_y_dot * w_341 + platform_z_dot * w_342)
                / w_323
            - w_343
                * ((w_320 * platform_x_dot + w_321 * platform_y_dot
                    + c1_on_platform_z * platform_z_dot) / w_323_squared);
        let minus_k_lambda_c1_leg_platform_q3 = w_324 * w_347 / w_323
            + mass_platform_q3_platform_q0 * l_lambda_c1_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_c1_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_c1_leg_platform_q2;
        let minus_l_lambda_c1_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_c1_leg_platform_q3;
        let c1_leg_by_platform_z = c1_on_platform_z * sqrt_w_323 / w_323;
        let l_lambda_c1_leg_platform_z = c1_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_c1_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_c1_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_c1_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_c1_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_c1_leg_platform_q2;
        let minus_l_lambda_c1_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_c1_leg_lambda_platform_norm;
        let c1_leg_by_platform_x = w_320 * sqrt_w_323 / w_323;
        let l_lambda_c1_leg_platform_x = c1_leg_by_platform_x * self.inverse_platform_x;
        let c1_leg_by_platform_y = w_321 * sqrt_w_323 / w_323;
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
        let w_366 = b2_leg_by_platform_q0 * l_lambda_b2_leg_platform_q0
            + k_lambda_b2_leg_platform_q1 * l_lambda_b2_leg_platform_q1
            + k_lambda_b2_leg_platform_q2 * l_lambda_b2_leg_platform_q2
            + minus_k_lambda_b2_leg_platform_q3 * minus_l_lambda_b2_leg_platform_q3
            + b2_leg_by_platform_x * l_lambda_b2_leg_platform_x
            + b2_leg_by_platform_y * l_lambda_b2_leg_platform_y
            + b2_leg_by_platform_z * l_lambda_b2_leg_platform_z;
        let pivot_lambda_b2_leg = k_lambda_b2_leg_lambda_platform_norm
            * minus_l_lambda_b2_leg_lambda_platform_norm - w_366
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
            - (sqrt_w_323 * w_365 + w_222 + w_318)
            - rhs_platform_q0 * l_lambda_c1_leg_platform_q0
            - l_lambda_c1_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_c1_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_c1_leg_platform_z
            + minus_l_lambda_c1_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_c1_leg_lambda_a1_leg * rhs_lambda_a1_leg
            - l_lambda_c1_leg_lambda_a2_leg * rhs_lambda_a2_leg
            - l_lambda_c1_leg_lambda_b1_leg * rhs_lambda_b1_leg
            - l_lambda_c1_leg_lambda_b2_leg * rhs_lambda_b2_leg;
        let w_367 = platform_x - self.k_39 - w_42 * self.k_40 + w_46 * self.k_41;
        let w_368 = platform_y - self.k_42 + w_49 * self.k_43 - w_51 * self.k_44;
        let w_369 = w_53 * self.k_43 + w_54 * self.k_41;
        let c2_on_platform_z = w * w_369 + platform_z;
        let w_370 = w_367 * w_367 + w_368 * w_368 + c2_on_platform_z * c2_on_platform_z;
        let sqrt_w_370 = w_370.sqrt();
        let w_371 = S::from_f64(2.0) * sqrt_w_370;
        let w_372 = w_58 * self.k_44 - w_61 * self.k_43 - w_63 * self.k_41;
        let w_373 = w_squared * (w_50 * self.k_41 - w_48 * self.k_43);
        let w_374 = platform_q2 * w_373 + w_58 * self.k_40;
        let w_375 = w_squared * w_369;
        let w_376 = w * (platform_q3 * self.k_44 - platform_q0 * self.k_40)
            - platform_q2 * w_375;
        let w_377 = w_367 * w_372 + w_368 * w_374 + c2_on_platform_z * w_376;
        let w_378 = w_squared * (w_40 * self.k_43 - w_45 * self.k_41);
        let w_379 = platform_q0 * w_378 - w_71 * self.k_44;
        let w_380 = platform_q0 * w_373 + w_71 * self.k_40;
        let w_381 = platform_q0 * w_375
            + w * (platform_q2 * self.k_40 - platform_q1 * self.k_44);
        let w_382 = w_367 * w_379 + w_368 * w_380 - c2_on_platform_z * w_381;
        let c2_leg_by_platform_q0 = w_382 * w_371 / w_370;
        let l_lambda_c2_leg_platform_q0 = c2_leg_by_platform_q0 * inverse_platform_q0;
        let w_383 = platform_q1 * w_378 + w_76 * self.k_44;
        let w_384 = w_76 * self.k_40 - w_79 * self.k_43 - w_82 * self.k_41;
        let w_385 = w * (platform_q3 * self.k_40 + platform_q0 * self.k_44)
            - platform_q1 * w_375;
        let w_386 = w_367 * w_383 + w_368 * w_384 + c2_on_platform_z * w_385;
        let k_lambda_c2_leg_platform_q1 = w_371 * w_386 / w_370
            - mass_platform_q1_platform_q0 * l_lambda_c2_leg_platform_q0;
        let l_lambda_c2_leg_platform_q1 = inverse_platform_q1
            * k_lambda_c2_leg_platform_q1;
        let k_lambda_c2_leg_platform_q2 = w_371 * w_377 / w_370
            - mass_platform_q2_platform_q0 * l_lambda_c2_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_c2_leg_platform_q1;
        let l_lambda_c2_leg_platform_q2 = inverse_platform_q2
            * k_lambda_c2_leg_platform_q2;
        let w_387 = platform_x_dot + w_87 * self.k_71 - w_88 * self.k_72
            - self.k_41 * w_90;
        let w_388 = platform_y_dot + self.k_43 * w_93 - w_94 * self.k_71
            + w_96 * self.k_72;
        let w_389 = w * (self.k_41 * w_98 - self.k_43 * w_99)
            - w_squared * w_20 * (w_53 * self.k_71 + w_54 * self.k_72) + platform_z_dot;
        let w_390 = w_367 * w_387 + w_368 * w_388 + c2_on_platform_z * w_389;
        let w_391 = w_102 * self.k_44 + w_103 * self.k_43 + w_104 * self.k_41;
        let w_392 = w_102 * self.k_40 - w_106 * self.k_43 - w_107 * self.k_41;
        let w_393 = w * (platform_q2 * self.k_44 + platform_q1 * self.k_40)
            - platform_q3 * w_375;
        let w_394 = w_367 * w_391 - w_368 * w_392 - c2_on_platform_z * w_393;
        let w_370_squared = w_370 * w_370;
        let w_395 = w_390
            * ((w_394 * platform_q3_dot - w_382 * platform_q0_dot
                - w_386 * platform_q1_dot - w_377 * platform_q2_dot) / w_370_squared);
        let w_396 = w_20 * w_24 * (w_45 * self.k_74 - w_40 * self.k_73);
        let w_397 = w_20 * w_24 * (w_48 * self.k_73 - w_50 * self.k_74);
        let w_398 = w_368
            * (w_squared * (self.k_41 * w_118 - self.k_43 * w_119 + w_120 * self.k_72)
                + platform_q0 * w_397 + self.k_40 * w_117);
        let w_399 = w_20 * w_24 * (w_53 * self.k_73 + w_54 * self.k_74);
        let w_400 = c2_on_platform_z
            * (w_squared * (self.k_43 * w_124 + self.k_41 * w_126) - platform_q0 * w_399
                + w * (self.k_40 * platform_q2_dot - self.k_44 * platform_q1_dot));
        let w_401 = w_379 * w_387
            + w_367
                * (w_squared
                    * (self.k_41 * w_113 + self.k_43 * w_114 + w_115 * self.k_71)
                    + platform_q0 * w_396 - self.k_44 * w_117) + w_380 * w_388 + w_398
            - w_381 * w_389 - w_400;
        let w_402 = w_367
            * (w_squared * (self.k_41 * w_130 + self.k_43 * w_131 + w_132 * self.k_71)
                + platform_q1 * w_396 + self.k_44 * w_133);
        let w_403 = c2_on_platform_z
            * (w_squared * (self.k_43 * w_140 - self.k_41 * w_142)
                + w * (self.k_40 * platform_q3_dot + self.k_44 * platform_q0_dot)
                + platform_q1 * w_399);
        let w_404 = w_383 * w_387 + w_402 + w_384 * w_388
            + w_368
                * (self.k_40 * w_133 - self.k_43 * w_135 + w_136 * self.k_73
                    - self.k_41 * w_139) + w_385 * w_389 + w_403;
        let w_405 = w_368
            * (w_squared * (self.k_41 * w_150 - self.k_43 * w_151 + w_152 * self.k_72)
                + platform_q2 * w_397 + self.k_40 * w_146);
        let w_406 = c2_on_platform_z
            * (w_squared * (self.k_43 * w_154 - self.k_41 * w_155)
                + w * (self.k_44 * platform_q3_dot - self.k_40 * platform_q0_dot)
                + platform_q2 * w_399);
        let w_407 = w_372 * w_387
            + w_367
                * (self.k_41 * w_145 + self.k_44 * w_146 - self.k_43 * w_148
                    + w_149 * self.k_74) + w_374 * w_388 + w_405 + w_376 * w_389 + w_406;
        let w_408 = w_368
            * (self.k_40 * w_159 - self.k_43 * w_162 + w_163 * self.k_73
                - self.k_41 * w_164);
        let w_409 = c2_on_platform_z
            * (w_squared * (self.k_43 * w_166 - self.k_41 * w_167)
                + w * (self.k_44 * platform_q2_dot + self.k_40 * platform_q1_dot)
                + platform_q3 * w_399);
        let w_410 = w_391 * w_387
            + w_367
                * (self.k_41 * w_158 + self.k_44 * w_159 + self.k_43 * w_160
                    - w_161 * self.k_74) - w_392 * w_388 - w_408 - w_393 * w_389 - w_409;
        let w_411 = S::from_f64(2.0)
            * (w_395
                + (platform_q0_dot * w_401 + platform_q1_dot * w_404
                    + platform_q2_dot * w_407 - platform_q3_dot * w_410) / w_370);
        let w_412 = w_411
            + (platform_x_dot * w_387 + platform_y_dot * w_388 + platform_z_dot * w_389)
                / w_370
            - w_390
                * ((w_367 * platform_x_dot + w_368 * platform_y_dot
                    + c2_on_platform_z * platform_z_dot) / w_370_squared);
        let w_413 = sqrt_w_370 * w_412 + w_222 - self.k_53 * sin_w_175;
        let minus_k_lambda_c2_leg_platform_q3 = w_371 * w_394 / w_370
            + mass_platform_q3_platform_q0 * l_lambda_c2_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_c2_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_c2_leg_platform_q2;
        let minus_l_lambda_c2_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_c2_leg_platform_q3;
        let c2_leg_by_platform_z = c2_on_platform_z * sqrt_w_370 / w_370;
        let l_lambda_c2_leg_platform_z = c2_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_c2_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_c2_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_c2_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_c2_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_c2_leg_platform_q2;
        let minus_l_lambda_c2_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_c2_leg_lambda_platform_norm;
        let c2_leg_by_platform_x = w_367 * sqrt_w_370 / w_370;
        let l_lambda_c2_leg_platform_x = c2_leg_by_platform_x * self.inverse_platform_x;
        let c2_leg_by_platform_y = w_368 * sqrt_w_370 / w_370;
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
        let w_414 = c1_leg_by_platform_q0 * l_lambda_c1_leg_platform_q0
            + k_lambda_c1_leg_platform_q1 * l_lambda_c1_leg_platform_q1
            + k_lambda_c1_leg_platform_q2 * l_lambda_c1_leg_platform_q2
            + minus_k_lambda_c1_leg_platform_q3 * minus_l_lambda_c1_leg_platform_q3
            + c1_leg_by_platform_x * l_lambda_c1_leg_platform_x
            + c1_leg_by_platform_y * l_lambda_c1_leg_platform_y
            + c1_leg_by_platform_z * l_lambda_c1_leg_platform_z;
        let pivot_lambda_c1_leg = k_lambda_c1_leg_lambda_platform_norm
            * minus_l_lambda_c1_leg_lambda_platform_norm - w_414
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
            - w_413 - rhs_platform_q0 * l_lambda_c2_leg_platform_q0
            - l_lambda_c2_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_c2_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_c2_leg_platform_z
            + minus_l_lambda_c2_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_c2_leg_lambda_a1_leg * rhs_lambda_a1_leg
            - l_lambda_c2_leg_lambda_a2_leg * rhs_lambda_a2_leg
            - l_lambda_c2_leg_lambda_b1_leg * rhs_lambda_b1_leg
            - l_lambda_c2_leg_lambda_b2_leg * rhs_lambda_b2_leg
            - l_lambda_c2_leg_lambda_c1_leg * rhs_lambda_c1_leg;
        let w_415 = c2_leg_by_platform_q0 * l_lambda_c2_leg_platform_q0
            + k_lambda_c2_leg_platform_q1 * l_lambda_c2_leg_platform_q1
            + k_lambda_c2_leg_platform_q2 * l_lambda_c2_leg_platform_q2
            + minus_k_lambda_c2_leg_platform_q3 * minus_l_lambda_c2_leg_platform_q3
            + c2_leg_by_platform_x * l_lambda_c2_leg_platform_x
            + c2_leg_by_platform_y * l_lambda_c2_leg_platform_y
            + c2_leg_by_platform_z * l_lambda_c2_leg_platform_z;
        let pivot_lambda_c2_leg = k_lambda_c2_leg_lambda_platform_norm
            * minus_l_lambda_c2_leg_lambda_platform_norm - w_415
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
        let w_416 = cos_w_172 * self.k_76;
        let w_417 = self.k_77 * cos_w_173;
        let w_418 = self.k_77 * cos_w_174;
        let w_419 = self.minus_rhs_platform_z * platform_z_dot
            + lambda_a1_leg * cos_w_172 * self.k_78 + lambda_a2_leg * (w_416 - w_417)
            + lambda_b1_leg * (w_416 + w_417) + lambda_b2_leg * (w_416 - w_418)
            + lambda_c1_leg * (w_416 + w_418)
            + lambda_c2_leg * (w_416 - self.k_77 * cos_w_175);
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
            power: -w_419,
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
                ) | sim_kernel::pivot_is_refused(pivot_lambda_a1_leg, w_224)
                | sim_kernel::pivot_is_refused(pivot_lambda_a2_leg, w_271)
                | sim_kernel::pivot_is_refused(pivot_lambda_b1_leg, w_319)
                | sim_kernel::pivot_is_refused(pivot_lambda_b2_leg, w_366)
                | sim_kernel::pivot_is_refused(pivot_lambda_c1_leg, w_414)
                | sim_kernel::pivot_is_refused(pivot_lambda_c2_leg, w_415),
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
