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
        let a2_head_angle = w_3 + self.head;
        let w_4 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_4 - self.foot;
        let b1_foot_angle = w_4 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_5 = S::from_f64(1.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        let b2_foot_angle = w_5 - self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let c1_foot_angle = w_5 + self.foot;
        let w_6 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_6 - self.head;
        let c2_head_angle = w_6 + self.head;
        let w_7 = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI);
        let c2_foot_angle = w_7 - self.foot;
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
    /// Operations: 22 additions, 44 multiplications, 1 division.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 7]) -> [[S; 7]; 7] {
        let [_, _, _, platform_q0, platform_q1, platform_q2, platform_q3] = *q;
        let platform_q1_squared = platform_q1 * platform_q1;
        let platform_q0_squared = platform_q0 * platform_q0;
        let platform_q2_squared = platform_q2 * platform_q2;
        let platform_q3_squared = platform_q3 * platform_q3;
        let w = S::from_f64(1.0)
            / (platform_q1_squared + platform_q0_squared + platform_q2_squared
                + platform_q3_squared);
        let w_squared = w * w;
        let w_2 = S::from_f64(4.0) * self.A;
        let w_3 = w_2 * (platform_q1_squared + platform_q2_squared);
        let w_4 = S::from_f64(4.0) * self.C;
        let w_5 = S::from_f64(1.3333333333333333) * (self.A * S::from_f64(2.0) + self.C);
        let w_6 = w_5 - w_squared * w_2;
        let w_7 = platform_q2 * platform_q3;
        let w_8 = w_squared * (w_2 - w_4);
        let mass_platform_q1_platform_q0 = platform_q1 * platform_q0 * w_6 + w_7 * w_8;
        let mass_platform_q3_platform_q2 = platform_q1 * platform_q0 * w_8 + w_6 * w_7;
        let w_9 = platform_q1 * platform_q3;
        let w_10 = w_squared * (w_4 - w_2);
        let w_13 = w_2 * (platform_q0_squared + platform_q3_squared);
        let w_11 = platform_q0 * platform_q2;
        let mass_platform_q2_platform_q0 = w_9 * w_10 + w_6 * w_11;
        let mass_platform_q3_platform_q1 = w_6 * w_9 + w_10 * w_11;
        let w_12 = w_5 - w_squared * w_4;
        let mass_platform_q3_platform_q0 = platform_q0 * platform_q3 * w_12;
        let mass_platform_q2_platform_q1 = platform_q1 * platform_q2 * w_12;
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
                w_squared * (w_13 + platform_q2_squared * w_4)
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
                w_squared * (w_13 + platform_q1_squared * w_4)
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
        let a2_head_angle = w + self.head;
        let w_2 = t * self.w;
        let w_3 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_3 - self.foot;
        let b1_foot_angle = w_3 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_4 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333);
        let b2_foot_angle = w_4 - self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let c1_foot_angle = w_4 + self.foot;
        let w_5 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_5 - self.head;
        let c2_head_angle = w_5 + self.head;
        let w_6 = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI);
        let c2_foot_angle = w_6 - self.foot;
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
            w_2 + w_3,
            b1_foot_angle,
            b1_head_angle,
            b2_foot_angle,
            b2_head_angle,
            w_2 + w_4,
            c1_foot_angle,
            c1_head_angle,
            c2_foot_angle,
            c2_head_angle,
            w_2 + w_6,
        ]);
        let w_10 = S::from_f64(1.0)
            / (platform_q0_squared + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_11 = S::from_f64(2.0) * w_10;
        let w_12 = (platform_q2_squared + platform_q3_squared) * w_11 - S::from_f64(1.0);
        let w_21 = w_11 * (platform_q1_squared + platform_q3_squared) - S::from_f64(1.0);
        let w_13 = self.r * S::from_f64(2.0);
        let w_14 = sin_a1_head_angle * w_13;
        let w_15 = platform_q1 * platform_q2;
        let w_16 = platform_q0 * platform_q3;
        let w_17 = w_10 * (w_15 - w_16);
        let w_20 = w_10 * (w_15 + w_16);
        let w_18 = platform_x - self.R * cos_foot - w_12 * self.r * cos_a1_head_angle
            + w_14 * w_17;
        let w_19 = cos_a1_head_angle * w_13;
        let w_22 = platform_y - self.R * sin_foot + w_19 * w_20
            - w_21 * self.r * sin_a1_head_angle;
        let w_23 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_24 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let a1_on_platform_z = platform_z + w_10 * (w_19 * w_23 + w_14 * w_24);
        let w_25 = w_13 * sin_a2_head_angle;
        let w_26 = platform_x - self.R * cos_a2_foot_angle
            - w_12 * self.r * cos_a2_head_angle + w_17 * w_25;
        let w_27 = w_13 * cos_a2_head_angle;
        let a2_on_platform_z = platform_z + w_10 * (w_23 * w_27 + w_24 * w_25);
        let w_28 = platform_y - self.R * sin_a2_foot_angle + w_20 * w_27
            - w_21 * self.r * sin_a2_head_angle;
        let w_29 = self.heave * sin_w_2;
        let w_30 = self.sway * w_7;
        let w_31 = w_13 * sin_b1_head_angle;
        let w_32 = platform_x - self.R * cos_b1_foot_angle
            - w_12 * self.r * cos_b1_head_angle + w_17 * w_31;
        let w_33 = w_13 * cos_b1_head_angle;
        let b1_on_platform_z = platform_z + w_10 * (w_23 * w_33 + w_24 * w_31);
        let w_34 = platform_y - self.R * sin_b1_foot_angle + w_20 * w_33
            - w_21 * self.r * sin_b1_head_angle;
        let w_35 = w_13 * sin_b2_head_angle;
        let w_36 = platform_x - self.R * cos_b2_foot_angle
            - w_12 * self.r * cos_b2_head_angle + w_17 * w_35;
        let w_37 = w_13 * cos_b2_head_angle;
        let b2_on_platform_z = platform_z + w_10 * (w_23 * w_37 + w_24 * w_35);
        let w_38 = platform_y - self.R * sin_b2_foot_angle + w_20 * w_37
            - w_21 * self.r * sin_b2_head_angle;
        let w_39 = self.sway * w_8;
        let w_40 = w_13 * sin_c1_head_angle;
        let w_41 = platform_x - self.R * cos_c1_foot_angle
            - w_12 * self.r * cos_c1_head_angle + w_17 * w_40;
        let w_42 = w_13 * cos_c1_head_angle;
        let c1_on_platform_z = platform_z + w_10 * (w_23 * w_42 + w_24 * w_40);
        let w_43 = platform_y - self.R * sin_c1_foot_angle + w_20 * w_42
            - w_21 * self.r * sin_c1_head_angle;
        let w_44 = w_13 * sin_c2_head_angle;
        let w_45 = platform_x - self.R * cos_c2_foot_angle
            - w_12 * self.r * cos_c2_head_angle + w_17 * w_44;
        let w_46 = w_13 * cos_c2_head_angle;
        let w_47 = platform_y - self.R * sin_c2_foot_angle + w_20 * w_46
            - w_21 * self.r * sin_c2_head_angle;
        let c2_on_platform_z = platform_z + w_10 * (w_23 * w_46 + w_24 * w_44);
        [
            platform_q0_squared - S::from_f64(1.0) + platform_q1_squared
                + platform_q2_squared + platform_q3_squared,
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
        let a2_head_angle = w + self.head;
        let w_2 = t * self.w;
        let w_3 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_3 - self.foot;
        let b1_foot_angle = w_3 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_4 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333);
        let b2_foot_angle = w_4 - self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let c1_foot_angle = w_4 + self.foot;
        let w_5 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_5 - self.head;
        let c2_head_angle = w_5 + self.head;
        let w_6 = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI);
        let c2_foot_angle = w_6 - self.foot;
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
            w_2 + w_3,
            b1_foot_angle,
            b1_head_angle,
            b2_foot_angle,
            b2_head_angle,
            w_2 + w_4,
            c1_foot_angle,
            c1_head_angle,
            c2_foot_angle,
            c2_head_angle,
            w_2 + w_6,
        ]);
        let w_10 = S::from_f64(1.0)
            / (platform_q0_squared + platform_q1_squared + platform_q2_squared
                + platform_q3_squared);
        let w_11 = S::from_f64(2.0) * w_10;
        let w_12 = (platform_q2_squared + platform_q3_squared) * w_11 - S::from_f64(1.0);
        let w_21 = w_11 * (platform_q1_squared + platform_q3_squared) - S::from_f64(1.0);
        let w_13 = self.r * S::from_f64(2.0);
        let w_14 = sin_a1_head_angle * w_13;
        let w_15 = platform_q1 * platform_q2;
        let w_16 = platform_q0 * platform_q3;
        let w_17 = w_10 * (w_15 - w_16);
        let w_20 = w_10 * (w_15 + w_16);
        let w_18 = platform_x - self.R * cos_foot - w_12 * self.r * cos_a1_head_angle
            + w_14 * w_17;
        let w_19 = cos_a1_head_angle * w_13;
        let w_22 = platform_y - self.R * sin_foot + w_19 * w_20
            - w_21 * self.r * sin_a1_head_angle;
        let w_23 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_24 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let a1_on_platform_z = platform_z + w_10 * (w_19 * w_23 + w_14 * w_24);
        let w_25 = (self.heave * sin_w_2).abs();
        let w_26 = w_13 * sin_a2_head_angle;
        let w_27 = platform_x - self.R * cos_a2_foot_angle
            - w_12 * self.r * cos_a2_head_angle + w_17 * w_26;
        let w_28 = w_13 * cos_a2_head_angle;
        let a2_on_platform_z = platform_z + w_10 * (w_23 * w_28 + w_24 * w_26);
        let w_29 = platform_y - self.R * sin_a2_foot_angle + w_20 * w_28
            - w_21 * self.r * sin_a2_head_angle;
        let w_30 = (self.sway * w_7).abs();
        let w_31 = w_13 * sin_b1_head_angle;
        let w_32 = platform_x - self.R * cos_b1_foot_angle
            - w_12 * self.r * cos_b1_head_angle + w_17 * w_31;
        let w_33 = w_13 * cos_b1_head_angle;
        let b1_on_platform_z = platform_z + w_10 * (w_23 * w_33 + w_24 * w_31);
        let w_34 = platform_y - self.R * sin_b1_foot_angle + w_20 * w_33
            - w_21 * self.r * sin_b1_head_angle;
        let w_35 = w_13 * sin_b2_head_angle;
        let w_36 = platform_x - self.R * cos_b2_foot_angle
            - w_12 * self.r * cos_b2_head_angle + w_17 * w_35;
        let w_37 = w_13 * cos_b2_head_angle;
        let b2_on_platform_z = platform_z + w_10 * (w_23 * w_37 + w_24 * w_35);
        let w_38 = platform_y - self.R * sin_b2_foot_angle + w_20 * w_37
            - w_21 * self.r * sin_b2_head_angle;
        let w_39 = (self.sway * w_8).abs();
        let w_40 = w_13 * sin_c1_head_angle;
        let w_41 = platform_x - self.R * cos_c1_foot_angle
            - w_12 * self.r * cos_c1_head_angle + w_17 * w_40;
        let w_42 = w_13 * cos_c1_head_angle;
        let c1_on_platform_z = platform_z + w_10 * (w_23 * w_42 + w_24 * w_40);
        let w_43 = platform_y - self.R * sin_c1_foot_angle + w_20 * w_42
            - w_21 * self.r * sin_c1_head_angle;
        let w_44 = w_13 * sin_c2_head_angle;
        let w_45 = platform_x - self.R * cos_c2_foot_angle
            - w_12 * self.r * cos_c2_head_angle + w_17 * w_44;
        let w_46 = w_13 * cos_c2_head_angle;
        let w_47 = platform_y - self.R * sin_c2_foot_angle + w_20 * w_46
            - w_21 * self.r * sin_c2_head_angle;
        let c2_on_platform_z = platform_z + w_10 * (w_23 * w_46 + w_24 * w_44);
        [
            S::from_f64(1.0) + platform_q0_squared.abs() + platform_q1_squared.abs()
                + platform_q2_squared.abs() + platform_q3_squared.abs(),
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
    /// Operations: 270 additions, 512 multiplications, 43 divisions, 12 sine-cosine pairs, 6 square roots.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 7]) -> [[S; 7]; 7] {
        let [platform_x, platform_y, platform_z, platform_q0, platform_q1, platform_q2,
        platform_q3] = *q;
        let w = S::from_f64(0.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        let a1_head_angle = w - self.head;
        let a2_head_angle = w + self.head;
        let w_2 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_2 - self.foot;
        let b1_foot_angle = w_2 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_3 = S::from_f64(1.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        let b2_foot_angle = w_3 - self.foot;
        let c1_foot_angle = w_3 + self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let w_4 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_4 - self.head;
        let c2_head_angle = w_4 + self.head;
        let c2_foot_angle = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI)
            - self.foot;
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
            / (platform_q1_squared + platform_q0 * platform_q0 + platform_q2_squared
                + platform_q3_squared);
        let w_20 = platform_q1_squared + platform_q3_squared;
        let w_7 = w_6 * S::from_f64(2.0);
        let w_8 = w_5 * w_7 - S::from_f64(1.0);
        let w_21 = w_7 * w_20 - S::from_f64(1.0);
        let w_9 = self.r * cos_a1_head_angle;
        let w_10 = S::from_f64(2.0) * self.r;
        let w_11 = sin_a1_head_angle * w_10;
        let w_12 = platform_q1 * platform_q2;
        let w_13 = platform_q0 * platform_q3;
        let w_14 = w_12 - w_13;
        let w_18 = w_12 + w_13;
        let w_15 = w_6 * w_14;
        let w_16 = platform_x - self.R * cos_foot - w_8 * w_9 + w_11 * w_15;
        let w_17 = cos_a1_head_angle * w_10;
        let w_19 = w_6 * w_18;
        let w_22 = self.r * sin_a1_head_angle;
        let w_23 = platform_y - self.R * sin_foot + w_17 * w_19 - w_21 * w_22;
        let w_24 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_25 = platform_q2 * platform_q3 + platform_q1 * platform_q0;
        let w_26 = w_17 * w_24 + w_11 * w_25;
        let a1_on_platform_z = platform_z + w_6 * w_26;
        let w_27 = w_16 * w_16 + w_23 * w_23 + a1_on_platform_z * a1_on_platform_z;
        let sqrt_w_27 = w_27.sqrt();
        let w_6_squared = w_6 * w_6;
        let w_28 = w_5 * w_17 - w_14 * w_11;
        let w_29 = platform_q3 * w_6;
        let w_30 = w_11 * w_20 - w_18 * w_17;
        let w_31 = platform_q0 * w_6_squared;
        let w_32 = a1_on_platform_z
            * (w_6 * (platform_q2 * w_9 - platform_q1 * w_22) + w_26 * w_31);
        let w_33 = S::from_f64(2.0) * sqrt_w_27;
        let w_34 = platform_q1 * w_6_squared;
        let w_35 = platform_q2 * w_6;
        let w_36 = w_18 * w_34;
        let w_37 = w_6 - w_6_squared * w_20;
        let w_38 = platform_q1 * w_37;
        let w_51 = platform_q3 * w_37;
        let w_39 = a1_on_platform_z
            * (w_6 * (platform_q3 * w_9 + platform_q0 * w_22) - w_26 * w_34);
        let w_40 = platform_q1 * w_6;
        let w_41 = w_6 - w_6_squared * w_5;
        let w_42 = platform_q2 * w_41;
        let w_47 = platform_q3 * w_41;
        let w_43 = platform_q2 * w_6_squared;
        let w_44 = w_14 * w_43;
        let w_45 = a1_on_platform_z
            * (w_6 * (platform_q3 * w_22 - platform_q0 * w_9) - w_26 * w_43);
        let w_46 = platform_q0 * w_6;
        let w_48 = platform_q3 * w_6_squared;
        let w_52 = a1_on_platform_z
            * (w_6 * (platform_q2 * w_22 + platform_q1 * w_9) - w_26 * w_48);
        let w_49 = w_14 * w_48;
        let w_50 = w_18 * w_48;
        let w_53 = w_33
            * (w_16 * (w_22 * w_46 + w_17 * w_47 + w_11 * w_49)
                - w_23 * (w_9 * w_46 - w_17 * w_50 - w_11 * w_51) - w_52);
        let w_54 = self.r * cos_a2_head_angle;
        let w_55 = w_10 * sin_a2_head_angle;
        let w_56 = platform_x - self.R * cos_a2_foot_angle - w_8 * w_54 + w_15 * w_55;
        let w_57 = w_10 * cos_a2_head_angle;
        let w_58 = self.r * sin_a2_head_angle;
        let w_59 = platform_y - self.R * sin_a2_foot_angle + w_19 * w_57 - w_21 * w_58;
        let w_60 = w_24 * w_57 + w_25 * w_55;
        let a2_on_platform_z = platform_z + w_6 * w_60;
        let w_61 = w_56 * w_56 + w_59 * w_59 + a2_on_platform_z * a2_on_platform_z;
        let sqrt_w_61 = w_61.sqrt();
        let w_62 = w_5 * w_57 - w_14 * w_55;
        let w_63 = w_20 * w_55 - w_18 * w_57;
        let w_64 = a2_on_platform_z
            * (w_6 * (platform_q2 * w_54 - platform_q1 * w_58) + w_31 * w_60);
        let w_65 = S::from_f64(2.0) * sqrt_w_61;
        let w_66 = a2_on_platform_z
            * (w_6 * (platform_q3 * w_54 + platform_q0 * w_58) - w_34 * w_60);
        let w_67 = a2_on_platform_z
            * (w_6 * (platform_q3 * w_58 - platform_q0 * w_54) - w_43 * w_60);
        let w_68 = a2_on_platform_z
            * (w_6 * (platform_q2 * w_58 + platform_q1 * w_54) - w_48 * w_60);
        let w_69 = w_65
            * (w_56 * (w_46 * w_58 + w_47 * w_57 + w_49 * w_55)
                - w_59 * (w_46 * w_54 - w_50 * w_57 - w_51 * w_55) - w_68);
        let w_70 = self.r * cos_b1_head_angle;
        let w_71 = w_10 * sin_b1_head_angle;
        let w_72 = platform_x - self.R * cos_b1_foot_angle - w_8 * w_70 + w_15 * w_71;
        let w_73 = w_10 * cos_b1_head_angle;
        let w_74 = self.r * sin_b1_head_angle;
        let w_75 = platform_y - self.R * sin_b1_foot_angle + w_19 * w_73 - w_21 * w_74;
        let w_76 = w_24 * w_73 + w_25 * w_71;
        let b1_on_platform_z = platform_z + w_6 * w_76;
        let w_77 = w_72 * w_72 + w_75 * w_75 + b1_on_platform_z * b1_on_platform_z;
        let sqrt_w_77 = w_77.sqrt();
        let w_78 = w_5 * w_73 - w_14 * w_71;
        let w_79 = w_20 * w_71 - w_18 * w_73;
        let w_80 = b1_on_platform_z
            * (w_6 * (platform_q2 * w_70 - platform_q1 * w_74) + w_31 * w_76);
        let w_81 = S::from_f64(2.0) * sqrt_w_77;
        let w_82 = b1_on_platform_z
            * (w_6 * (platform_q3 * w_70 + platform_q0 * w_74) - w_34 * w_76);
        let w_83 = b1_on_platform_z
            * (w_6 * (platform_q3 * w_74 - platform_q0 * w_70) - w_43 * w_76);
        let w_84 = b1_on_platform_z
            * (w_6 * (platform_q2 * w_74 + platform_q1 * w_70) - w_48 * w_76);
        let w_85 = w_81
            * (w_72 * (w_46 * w_74 + w_47 * w_73 + w_49 * w_71)
                - w_75 * (w_46 * w_70 - w_50 * w_73 - w_51 * w_71) - w_84);
        let w_86 = self.r * cos_b2_head_angle;
        let w_87 = w_10 * sin_b2_head_angle;
        let w_88 = platform_x - self.R * cos_b2_foot_angle - w_8 * w_86 + w_15 * w_87;
        let w_89 = w_10 * cos_b2_head_angle;
        let w_90 = self.r * sin_b2_head_angle;
        let w_91 = platform_y - self.R * sin_b2_foot_angle + w_19 * w_89 - w_21 * w_90;
        let w_92 = w_24 * w_89 + w_25 * w_87;
        let b2_on_platform_z = platform_z + w_6 * w_92;
        let w_93 = w_88 * w_88 + w_91 * w_91 + b2_on_platform_z * b2_on_platform_z;
        let sqrt_w_93 = w_93.sqrt();
        let w_94 = w_5 * w_89 - w_14 * w_87;
        let w_95 = w_20 * w_87 - w_18 * w_89;
        let w_96 = b2_on_platform_z
            * (w_6 * (platform_q2 * w_86 - platform_q1 * w_90) + w_31 * w_92);
        let w_97 = S::from_f64(2.0) * sqrt_w_93;
        let w_98 = b2_on_platform_z
            * (w_6 * (platform_q3 * w_86 + platform_q0 * w_90) - w_34 * w_92);
        let w_99 = b2_on_platform_z
            * (w_6 * (platform_q3 * w_90 - platform_q0 * w_86) - w_43 * w_92);
        let w_100 = b2_on_platform_z
            * (w_6 * (platform_q2 * w_90 + platform_q1 * w_86) - w_48 * w_92);
        let w_101 = w_97
            * (w_88 * (w_46 * w_90 + w_47 * w_89 + w_49 * w_87)
                - w_91 * (w_46 * w_86 - w_50 * w_89 - w_51 * w_87) - w_100);
        let w_102 = self.r * cos_c1_head_angle;
        let w_103 = w_10 * sin_c1_head_angle;
        let w_104 = platform_x - self.R * cos_c1_foot_angle - w_8 * w_102 + w_15 * w_103;
        let w_105 = w_10 * cos_c1_head_angle;
        let w_106 = self.r * sin_c1_head_angle;
        let w_107 = platform_y - self.R * sin_c1_foot_angle + w_19 * w_105
            - w_21 * w_106;
        let w_108 = w_24 * w_105 + w_25 * w_103;
        let c1_on_platform_z = platform_z + w_6 * w_108;
        let w_109 = w_104 * w_104 + w_107 * w_107 + c1_on_platform_z * c1_on_platform_z;
        let sqrt_w_109 = w_109.sqrt();
        let w_110 = w_5 * w_105 - w_14 * w_103;
        let w_111 = w_20 * w_103 - w_18 * w_105;
        let w_112 = c1_on_platform_z
            * (w_6 * (platform_q2 * w_102 - platform_q1 * w_106) + w_31 * w_108);
        let w_113 = S::from_f64(2.0) * sqrt_w_109;
        let w_114 = c1_on_platform_z
            * (w_6 * (platform_q3 * w_102 + platform_q0 * w_106) - w_34 * w_108);
        let w_115 = c1_on_platform_z
            * (w_6 * (platform_q3 * w_106 - platform_q0 * w_102) - w_43 * w_108);
        let w_116 = c1_on_platform_z
            * (w_6 * (platform_q2 * w_106 + platform_q1 * w_102) - w_48 * w_108);
        let w_117 = w_113
            * (w_104 * (w_46 * w_106 + w_47 * w_105 + w_49 * w_103)
                - w_107 * (w_46 * w_102 - w_50 * w_105 - w_51 * w_103) - w_116);
        let w_118 = self.r * cos_c2_head_angle;
        let w_119 = w_10 * sin_c2_head_angle;
        let w_120 = platform_x - self.R * cos_c2_foot_angle - w_8 * w_118 + w_15 * w_119;
        let w_121 = w_10 * cos_c2_head_angle;
        let w_124 = w_24 * w_121 + w_25 * w_119;
        let w_126 = w_5 * w_121 - w_14 * w_119;
        let w_127 = w_20 * w_119 - w_18 * w_121;
        let w_122 = self.r * sin_c2_head_angle;
        let w_123 = platform_y - self.R * sin_c2_foot_angle + w_19 * w_121
            - w_21 * w_122;
        let c2_on_platform_z = platform_z + w_6 * w_124;
        let w_128 = c2_on_platform_z
            * (w_6 * (platform_q2 * w_118 - platform_q1 * w_122) + w_31 * w_124);
        let w_132 = c2_on_platform_z
            * (w_6 * (platform_q2 * w_122 + platform_q1 * w_118) - w_48 * w_124);
        let w_125 = w_120 * w_120 + w_123 * w_123 + c2_on_platform_z * c2_on_platform_z;
        let sqrt_w_125 = w_125.sqrt();
        let w_129 = S::from_f64(2.0) * sqrt_w_125;
        let w_133 = w_129
            * (w_120 * (w_46 * w_122 + w_47 * w_121 + w_49 * w_119)
                - w_123 * (w_46 * w_118 - w_50 * w_121 - w_51 * w_119) - w_132);
        let w_130 = c2_on_platform_z
            * (w_6 * (platform_q3 * w_118 + platform_q0 * w_122) - w_34 * w_124);
        let w_131 = c2_on_platform_z
            * (w_6 * (platform_q3 * w_122 - platform_q0 * w_118) - w_43 * w_124);
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
                (w_16 * (platform_q0 * w_6_squared * w_28 - w_22 * w_29)
                    + w_23 * (platform_q0 * w_6_squared * w_30 + w_9 * w_29) - w_32)
                    * w_33 / w_27,
                w_33
                    * (w_16 * (w_28 * w_34 + w_22 * w_35)
                        + w_23 * (w_9 * w_35 - w_17 * w_36 - w_11 * w_38) + w_39) / w_27,
                w_33
                    * (w_16 * (w_22 * w_40 - w_17 * w_42 - w_11 * w_44)
                        + w_23 * (w_9 * w_40 + w_30 * w_43) + w_45) / w_27,
                -(w_53 / w_27),
            ],
            [
                w_56 * sqrt_w_61 / w_61,
                w_59 * sqrt_w_61 / w_61,
                a2_on_platform_z * sqrt_w_61 / w_61,
                (w_56 * (platform_q0 * w_6_squared * w_62 - w_29 * w_58)
                    + w_59 * (platform_q0 * w_6_squared * w_63 + w_29 * w_54) - w_64)
                    * w_65 / w_61,
                w_65
                    * (w_56 * (w_34 * w_62 + w_35 * w_58)
                        + w_59 * (w_35 * w_54 - w_36 * w_57 - w_38 * w_55) + w_66)
                    / w_61,
                w_65
                    * (w_56 * (w_40 * w_58 - w_42 * w_57 - w_44 * w_55)
                        + w_59 * (w_40 * w_54 + w_43 * w_63) + w_67) / w_61,
                -(w_69 / w_61),
            ],
            [
                w_72 * sqrt_w_77 / w_77,
                w_75 * sqrt_w_77 / w_77,
                b1_on_platform_z * sqrt_w_77 / w_77,
                (w_72 * (platform_q0 * w_6_squared * w_78 - w_29 * w_74)
                    + w_75 * (platform_q0 * w_6_squared * w_79 + w_29 * w_70) - w_80)
                    * w_81 / w_77,
                w_81
                    * (w_72 * (w_34 * w_78 + w_35 * w_74)
                        + w_75 * (w_35 * w_70 - w_36 * w_73 - w_38 * w_71) + w_82)
                    / w_77,
                w_81
                    * (w_72 * (w_40 * w_74 - w_42 * w_73 - w_44 * w_71)
                        + w_75 * (w_40 * w_70 + w_43 * w_79) + w_83) / w_77,
                -(w_85 / w_77),
            ],
            [
                w_88 * sqrt_w_93 / w_93,
                w_91 * sqrt_w_93 / w_93,
                b2_on_platform_z * sqrt_w_93 / w_93,
                (w_88 * (platform_q0 * w_6_squared * w_94 - w_29 * w_90)
                    + w_91 * (platform_q0 * w_6_squared * w_95 + w_29 * w_86) - w_96)
                    * w_97 / w_93,
                w_97
                    * (w_88 * (w_34 * w_94 + w_35 * w_90)
                        + w_91 * (w_35 * w_86 - w_36 * w_89 - w_38 * w_87) + w_98)
                    / w_93,
                w_97
                    * (w_88 * (w_40 * w_90 - w_42 * w_89 - w_44 * w_87)
                        + w_91 * (w_40 * w_86 + w_43 * w_95) + w_99) / w_93,
                -(w_101 / w_93),
            ],
            [
                w_104 * sqrt_w_109 / w_109,
                w_107 * sqrt_w_109 / w_109,
                c1_on_platform_z * sqrt_w_109 / w_109,
                (w_104 * (platform_q0 * w_6_squared * w_110 - w_29 * w_106)
                    + w_107 * (platform_q0 * w_6_squared * w_111 + w_29 * w_102) - w_112)
                    * w_113 / w_109,
                w_113
                    * (w_104 * (w_34 * w_110 + w_35 * w_106)
                        + w_107 * (w_35 * w_102 - w_36 * w_105 - w_38 * w_103) + w_114)
                    / w_109,
                w_113
                    * (w_104 * (w_40 * w_106 - w_42 * w_105 - w_44 * w_103)
                        + w_107 * (w_40 * w_102 + w_43 * w_111) + w_115) / w_109,
                -(w_117 / w_109),
            ],
            [
                w_120 * sqrt_w_125 / w_125,
                w_123 * sqrt_w_125 / w_125,
                c2_on_platform_z * sqrt_w_125 / w_125,
                (w_120 * (platform_q0 * w_6_squared * w_126 - w_29 * w_122)
                    + w_123 * (platform_q0 * w_6_squared * w_127 + w_29 * w_118) - w_128)
                    * w_129 / w_125,
                w_129
                    * (w_120 * (w_34 * w_126 + w_35 * w_122)
                        + w_123 * (w_35 * w_118 - w_36 * w_121 - w_38 * w_119) + w_130)
                    / w_125,
                w_129
                    * (w_120 * (w_40 * w_122 - w_42 * w_121 - w_44 * w_119)
                        + w_123 * (w_40 * w_118 + w_43 * w_127) + w_131) / w_125,
                -(w_133 / w_125),
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
            w + S::from_f64(0.6666666666666666) * S::from_f64(::core::f64::consts::PI),
            w + S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333),
            w + S::from_f64(::core::f64::consts::PI) * S::from_f64(2.0),
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
    /// Operations: 927 additions, 1494 multiplications, 25 divisions, 16 sine-cosine pairs, 6 square roots.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        let [platform_x, platform_y, platform_z, platform_q0, platform_q1, platform_q2,
        platform_q3] = *q;
        let [platform_x_dot, platform_y_dot, platform_z_dot, platform_q0_dot,
        platform_q1_dot, platform_q2_dot, platform_q3_dot] = *qd;
        let w = self.w * t;
        let w_2 = S::from_f64(0.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        let a1_head_angle = w_2 - self.head;
        let a2_head_angle = w_2 + self.head;
        let w_3 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_3 - self.foot;
        let b1_foot_angle = w_3 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_4 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333);
        let b2_foot_angle = w_4 - self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let c1_foot_angle = w_4 + self.foot;
        let w_5 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_5 - self.head;
        let c2_head_angle = w_5 + self.head;
        let w_6 = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI);
        let c2_foot_angle = w_6 - self.foot;
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
            w + w_3,
            a2_foot_angle,
            a2_head_angle,
            b1_foot_angle,
            b1_head_angle,
            w + w_4,
            b2_foot_angle,
            b2_head_angle,
            c1_foot_angle,
            c1_head_angle,
            w + w_6,
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
        let w_25 = platform_q1_squared + platform_q3_squared;
        let w_12 = S::from_f64(2.0) * w_11;
        let w_13 = w_10 * w_12 - S::from_f64(1.0);
        let w_26 = w_12 * w_25 - S::from_f64(1.0);
        let w_14 = self.r * cos_a1_head_angle;
        let w_15 = S::from_f64(2.0) * self.r;
        let w_16 = sin_a1_head_angle * w_15;
        let w_17 = platform_q1 * platform_q2;
        let w_18 = platform_q0 * platform_q3;
        let w_19 = w_17 - w_18;
        let w_23 = w_17 + w_18;
        let w_20 = w_11 * w_19;
        let w_21 = platform_x - self.R * cos_foot - w_13 * w_14 + w_16 * w_20;
        let w_22 = cos_a1_head_angle * w_15;
        let w_24 = w_11 * w_23;
        let w_27 = self.r * sin_a1_head_angle;
        let w_28 = platform_y - self.R * sin_foot + w_22 * w_24 - w_26 * w_27;
        let w_29 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_30 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let w_31 = w_22 * w_29 + w_16 * w_30;
        let a1_on_platform_z = platform_z + w_11 * w_31;
        let w_32 = w_21 * w_21 + w_28 * w_28 + a1_on_platform_z * a1_on_platform_z;
        let w_11_squared = w_11 * w_11;
        let w_33 = platform_q1_dot * platform_q1;
        let w_34 = platform_q2_dot * platform_q2;
        let w_35 = platform_q3_dot * platform_q3;
        let w_36 = platform_q0_dot * platform_q0 + w_33 + w_34 + w_35;
        let w_38 = w_34 + w_35;
        let w_54 = w_33 + w_35;
        let w_37 = w_11_squared * w_36;
        let w_39 = w_10 * w_37 - w_11 * w_38;
        let w_40 = self.r * S::from_f64(4.0);
        let w_41 = cos_a1_head_angle * w_40;
        let w_42 = sin_a1_head_angle * w_40;
        let w_43 = w_19 * w_37;
        let w_44 = platform_q3_dot * platform_q0;
        let w_45 = platform_q0_dot * platform_q3;
        let w_46 = platform_q2_dot * platform_q1;
        let w_47 = platform_q1_dot * platform_q2;
        let w_48 = w_44 + w_45 - w_46 - w_47;
        let w_51 = w_44 + w_45 + w_46 + w_47;
        let w_49 = w_11 * w_48;
        let w_50 = platform_x_dot + w_39 * w_41 - w_42 * w_43 - w_16 * w_49;
        let w_52 = w_11 * w_51;
        let w_53 = w_23 * w_37;
        let w_55 = w_25 * w_37 - w_11 * w_54;
        let w_56 = platform_y_dot + w_22 * w_52 - w_41 * w_53 + w_42 * w_55;
        let w_57 = platform_q1_dot * platform_q0 + platform_q0_dot * platform_q1
            + platform_q3_dot * platform_q2 + platform_q2_dot * platform_q3;
        let w_58 = platform_q2_dot * platform_q0 + platform_q0_dot * platform_q2
            - platform_q1_dot * platform_q3 - platform_q3_dot * platform_q1;
        let w_59 = w_16 * w_57 - w_22 * w_58;
        let w_60 = platform_z_dot - w_11_squared * w_36 * (w_29 * w_41 + w_30 * w_42)
            + w_11 * w_59;
        let w_97 = w_38 * w_41 + w_16 * w_48;
        let w_61 = w_21 * w_50 + w_28 * w_56 + a1_on_platform_z * w_60;
        let w_62 = platform_q0 * w_11;
        let w_63 = w_11 - w_10 * w_11_squared;
        let w_64 = platform_q3 * w_63;
        let w_65 = platform_q3 * w_11_squared;
        let w_66 = w_19 * w_65;
        let w_67 = w_27 * w_62 + w_22 * w_64 + w_16 * w_66;
        let w_68 = w_23 * w_65;
        let w_69 = w_11 - w_25 * w_11_squared;
        let w_70 = platform_q3 * w_69;
        let w_71 = w_14 * w_62 - w_22 * w_68 - w_16 * w_70;
        let w_72 = w_11 * (platform_q2 * w_27 + platform_q1 * w_14) - w_31 * w_65;
        let w_73 = w_10 * w_22 - w_19 * w_16;
        let w_74 = platform_q3 * w_11;
        let w_75 = platform_q0 * w_11_squared * w_73 - w_27 * w_74;
        let w_76 = w_16 * w_25 - w_23 * w_22;
        let w_77 = platform_q0 * w_11_squared * w_76 + w_14 * w_74;
        let w_78 = platform_q0 * w_11_squared;
        let w_79 = w_11 * (platform_q2 * w_14 - platform_q1 * w_27) + w_31 * w_78;
        let w_80 = platform_q1 * w_11_squared;
        let w_81 = platform_q2 * w_11;
        let w_82 = w_73 * w_80 + w_27 * w_81;
        let w_83 = w_23 * w_80;
        let w_84 = platform_q1 * w_69;
        let w_85 = w_14 * w_81 - w_22 * w_83 - w_16 * w_84;
        let w_86 = w_11 * (platform_q3 * w_14 + platform_q0 * w_27) - w_31 * w_80;
        let w_87 = platform_q1_dot
            * (w_21 * w_82 + w_28 * w_85 + a1_on_platform_z * w_86);
        let w_88 = platform_q1 * w_11;
        let w_89 = platform_q2 * w_63;
        let w_90 = platform_q2 * w_11_squared;
        let w_91 = w_19 * w_90;
        let w_92 = w_27 * w_88 - w_22 * w_89 - w_16 * w_91;
        let w_93 = w_14 * w_88 + w_76 * w_90;
        let w_94 = w_11 * (platform_q3 * w_27 - platform_q0 * w_14) - w_31 * w_90;
        let w_95 = platform_q2_dot
            * (w_21 * w_92 + w_28 * w_93 + a1_on_platform_z * w_94);
        let w_96 = platform_q3_dot
            * (w_21 * w_67 - w_28 * w_71 - a1_on_platform_z * w_72)
            - platform_q0_dot * (w_21 * w_75 + w_28 * w_77 - a1_on_platform_z * w_79)
            - w_87 - w_95;
        let w_32_squared = w_32 * w_32;
        let w_98 = platform_q3 * w_36;
        let w_99 = w_11 * w_11_squared;
        let w_100 = self.r * S::from_f64(8.0);
        let w_101 = sin_a1_head_angle * w_100;
        let w_102 = cos_a1_head_angle * w_100;
        let w_103 = w_19 * w_101 - w_10 * w_102;
        let w_104 = platform_q3_dot * w_11;
        let w_105 = w_21
            * (w_11_squared * (platform_q0 * w_97 + platform_q0_dot * w_73 + w_16 * w_98)
                + platform_q0 * w_36 * w_99 * w_103 - w_27 * w_104);
        let w_106 = w_98 + platform_q0 * w_51;
        let w_107 = platform_q0 * w_54;
        let w_108 = w_23 * w_102 - w_25 * w_101;
        let w_109 = w_28
            * (w_11_squared * (platform_q0_dot * w_76 - w_22 * w_106 + w_42 * w_107)
                + platform_q0 * w_36 * w_99 * w_108 + w_14 * w_104);
        let w_110 = w_11_squared
            * (w_36 * (platform_q1 * w_16 - platform_q2 * w_22) + platform_q0_dot * w_31
                + platform_q0 * w_59);
        let w_111 = w_29 * w_102 + w_30 * w_101;
        let w_112 = w_50 * w_75 + w_105 + w_56 * w_77 + w_109 - w_60 * w_79
            - a1_on_platform_z
                * (w_110 - platform_q0 * w_36 * w_99 * w_111
                    + w_11 * (platform_q2_dot * w_14 - platform_q1_dot * w_27));
        let w_113 = platform_q2 * w_36;
        let w_114 = w_36 * w_99;
        let w_115 = platform_q1 * w_114;
        let w_116 = platform_q2_dot * w_11;
        let w_117 = w_21
            * (w_11_squared
                * (platform_q1_dot * w_73 + platform_q1 * w_97 - w_16 * w_113)
                + w_103 * w_115 + w_27 * w_116);
        let w_118 = w_11_squared * (w_113 + platform_q1_dot * w_23 + platform_q1 * w_51);
        let w_119 = w_23 * w_115;
        let w_120 = S::from_f64(4.0) * w_114;
        let w_121 = w_25 * w_120;
        let w_129 = w_10 * w_120;
        let w_122 = w_36 + w_54;
        let w_135 = platform_q2 * w_54;
        let w_123 = platform_q1 * (w_121 - S::from_f64(2.0) * w_11_squared * w_122)
            + platform_q1_dot * w_69;
        let w_124 = w_11 * (platform_q3_dot * w_14 + platform_q0_dot * w_27)
            - w_11_squared
                * (w_36 * (platform_q3 * w_22 + platform_q0 * w_16)
                    + platform_q1_dot * w_31 + platform_q1 * w_59) + w_111 * w_115;
        let w_125 = w_50 * w_82 + w_117 + w_56 * w_85
            + w_28 * (w_14 * w_116 - w_22 * w_118 + w_102 * w_119 - w_16 * w_123)
            + w_60 * w_86 + a1_on_platform_z * w_124;
        let w_126 = platform_q1 * w_36;
        let w_127 = w_11_squared * (platform_q2 * w_48 - w_126 - platform_q2_dot * w_19);
        let w_134 = w_126 + platform_q2 * w_51;
        let w_128 = platform_q1_dot * w_11;
        let w_130 = w_36 + w_38;
        let w_131 = platform_q2 * (w_129 - S::from_f64(2.0) * w_11_squared * w_130)
            + platform_q2_dot * w_63;
        let w_132 = platform_q2 * w_114;
        let w_136 = w_28
            * (w_11_squared * (platform_q2_dot * w_76 - w_22 * w_134 + w_42 * w_135)
                + w_14 * w_128 + w_108 * w_132);
        let w_144 = platform_q3 * w_114;
        let w_133 = w_19 * w_132;
        let w_137 = w_11_squared
            * (w_36 * (platform_q0 * w_22 - platform_q3 * w_16) - platform_q2_dot * w_31
                - platform_q2 * w_59)
            + w_11 * (platform_q3_dot * w_27 - platform_q0_dot * w_14) + w_111 * w_132;
        let w_138 = w_50 * w_92
            + w_21 * (w_16 * w_127 + w_27 * w_128 - w_22 * w_131 + w_101 * w_133)
            + w_56 * w_93 + w_136 + w_60 * w_94 + a1_on_platform_z * w_137;
        let w_150 = w_11 * (platform_q2_dot * w_27 + platform_q1_dot * w_14)
            - w_11_squared
                * (w_36 * (platform_q2 * w_16 + platform_q1 * w_22)
                    + platform_q3_dot * w_31 + platform_q3 * w_59) + w_111 * w_144;
        let w_139 = platform_q0 * w_36;
        let w_146 = w_11_squared * (w_139 + platform_q3_dot * w_23 + platform_q3 * w_51);
        let w_140 = w_11_squared * (platform_q3_dot * w_19 - w_139 - platform_q3 * w_48);
        let w_141 = platform_q0_dot * w_11;
        let w_142 = S::from_f64(2.0) * w_11_squared;
        let w_143 = platform_q3 * (w_129 - w_130 * w_142) + platform_q3_dot * w_63;
        let w_148 = platform_q3 * (w_121 - w_122 * w_142) + platform_q3_dot * w_69;
        let w_145 = w_19 * w_144;
        let w_147 = w_23 * w_144;
        let w_149 = w_28 * (w_14 * w_141 - w_22 * w_146 + w_102 * w_147 - w_16 * w_148);
        let w_151 = w_50 * w_67
            + w_21 * (w_16 * w_140 + w_27 * w_141 + w_22 * w_143 - w_101 * w_145)
            - w_56 * w_71 - w_149 - w_60 * w_72 - a1_on_platform_z * w_150;
        let w_152 = S::from_f64(2.0)
            * (w_61 * (w_96 / w_32_squared)
                + (platform_q0_dot * w_112 + platform_q1_dot * w_125
                    + platform_q2_dot * w_138 - platform_q3_dot * w_151) / w_32);
        let w_153 = w_152
            + (platform_x_dot * w_50 + platform_y_dot * w_56 + platform_z_dot * w_60)
                / w_32
            - w_61
                * ((platform_x_dot * w_21 + w_28 * platform_y_dot
                    + a1_on_platform_z * platform_z_dot) / w_32_squared);
        let w_squared = self.w * self.w;
        let w_154 = self.heave * w_squared;
        let w_155 = w_squared * self.sway;
        let w_156 = self.r * cos_a2_head_angle;
        let w_157 = w_15 * sin_a2_head_angle;
        let w_158 = platform_x - self.R * cos_a2_foot_angle - w_13 * w_156
            + w_20 * w_157;
        let w_159 = w_15 * cos_a2_head_angle;
        let w_160 = self.r * sin_a2_head_angle;
        let w_161 = platform_y - self.R * sin_a2_foot_angle + w_24 * w_159
            - w_26 * w_160;
        let w_162 = w_29 * w_159 + w_30 * w_157;
        let a2_on_platform_z = platform_z + w_11 * w_162;
        let w_163 = w_158 * w_158 + w_161 * w_161 + a2_on_platform_z * a2_on_platform_z;
        let w_164 = w_40 * cos_a2_head_angle;
        let w_165 = w_40 * sin_a2_head_angle;
        let w_166 = platform_x_dot + w_39 * w_164 - w_43 * w_165 - w_49 * w_157;
        let w_167 = platform_y_dot + w_52 * w_159 - w_53 * w_164 + w_55 * w_165;
        let w_168 = w_57 * w_157 - w_58 * w_159;
        let w_169 = platform_z_dot - w_11_squared * w_36 * (w_29 * w_164 + w_30 * w_165)
            + w_11 * w_168;
        let w_188 = w_38 * w_164 + w_48 * w_157;
        let w_170 = w_158 * w_166 + w_161 * w_167 + a2_on_platform_z * w_169;
        let w_171 = w_62 * w_160 + w_64 * w_159 + w_66 * w_157;
        let w_172 = w_62 * w_156 - w_68 * w_159 - w_70 * w_157;
        let w_173 = w_11 * (platform_q2 * w_160 + platform_q1 * w_156) - w_65 * w_162;
        let w_174 = w_10 * w_159 - w_19 * w_157;
        let w_175 = platform_q0 * w_11_squared * w_174 - w_74 * w_160;
        let w_176 = w_25 * w_157 - w_23 * w_159;
        let w_177 = platform_q0 * w_11_squared * w_176 + w_74 * w_156;
        let w_178 = w_11 * (platform_q2 * w_156 - platform_q1 * w_160) + w_78 * w_162;
        let w_179 = w_80 * w_174 + w_81 * w_160;
        let w_180 = w_81 * w_156 - w_83 * w_159 - w_84 * w_157;
        let w_181 = w_11 * (platform_q3 * w_156 + platform_q0 * w_160) - w_80 * w_162;
        let w_182 = platform_q1_dot
            * (w_158 * w_179 + w_161 * w_180 + a2_on_platform_z * w_181);
        let w_183 = w_88 * w_160 - w_89 * w_159 - w_91 * w_157;
        let w_184 = w_88 * w_156 + w_90 * w_176;
        let w_185 = w_11 * (platform_q3 * w_160 - platform_q0 * w_156) - w_90 * w_162;
        let w_186 = platform_q2_dot
            * (w_158 * w_183 + w_161 * w_184 + a2_on_platform_z * w_185);
        let w_187 = platform_q3_dot
            * (w_158 * w_171 - w_161 * w_172 - a2_on_platform_z * w_173)
            - platform_q0_dot
                * (w_158 * w_175 + w_161 * w_177 - a2_on_platform_z * w_178) - w_182
            - w_186;
        let w_163_squared = w_163 * w_163;
        let w_189 = w_100 * sin_a2_head_angle;
        let w_190 = w_100 * cos_a2_head_angle;
        let w_191 = w_19 * w_189 - w_10 * w_190;
        let w_192 = w_158
            * (w_11_squared
                * (platform_q0 * w_188 + platform_q0_dot * w_174 + w_98 * w_157)
                + platform_q0 * w_36 * w_99 * w_191 - w_104 * w_160);
        let w_198 = w_158
            * (w_11_squared
                * (platform_q1_dot * w_174 + platform_q1 * w_188 - w_113 * w_157)
                + w_115 * w_191 + w_116 * w_160);
        let w_193 = w_23 * w_190 - w_25 * w_189;
        let w_194 = w_161
            * (w_11_squared * (platform_q0_dot * w_176 - w_106 * w_159 + w_107 * w_165)
                + platform_q0 * w_36 * w_99 * w_193 + w_104 * w_156);
        let w_201 = w_161
            * (w_11_squared * (platform_q2_dot * w_176 - w_134 * w_159 + w_135 * w_165)
                + w_128 * w_156 + w_132 * w_193);
        let w_195 = w_11_squared
            * (w_36 * (platform_q1 * w_157 - platform_q2 * w_159)
                + platform_q0_dot * w_162 + platform_q0 * w_168);
        let w_196 = w_29 * w_190 + w_30 * w_189;
        let w_197 = w_166 * w_175 + w_192 + w_167 * w_177 + w_194 - w_169 * w_178
            - a2_on_platform_z
                * (w_195 - platform_q0 * w_36 * w_99 * w_196
                    + w_11 * (platform_q2_dot * w_156 - platform_q1_dot * w_160));
        let w_199 = w_11 * (platform_q3_dot * w_156 + platform_q0_dot * w_160)
            - w_11_squared
                * (w_36 * (platform_q3 * w_159 + platform_q0 * w_157)
                    + platform_q1_dot * w_162 + platform_q1 * w_168) + w_115 * w_196;
        let w_200 = w_166 * w_179 + w_198 + w_167 * w_180
            + w_161 * (w_116 * w_156 - w_118 * w_159 + w_119 * w_190 - w_123 * w_157)
            + w_169 * w_181 + a2_on_platform_z * w_199;
        let w_204 = w_161
            * (w_141 * w_156 - w_146 * w_159 + w_147 * w_190 - w_148 * w_157);
        let w_202 = w_11_squared
            * (w_36 * (platform_q0 * w_159 - platform_q3 * w_157)
                - platform_q2_dot * w_162 - platform_q2 * w_168)
            + w_11 * (platform_q3_dot * w_160 - platform_q0_dot * w_156) + w_132 * w_196;
        let w_203 = w_166 * w_183
            + w_158 * (w_127 * w_157 + w_128 * w_160 - w_131 * w_159 + w_133 * w_189)
            + w_167 * w_184 + w_201 + w_169 * w_185 + a2_on_platform_z * w_202;
        let w_205 = w_11 * (platform_q2_dot * w_160 + platform_q1_dot * w_156)
            - w_11_squared
                * (w_36 * (platform_q2 * w_157 + platform_q1 * w_159)
                    + platform_q3_dot * w_162 + platform_q3 * w_168) + w_144 * w_196;
        let w_206 = w_166 * w_171
            + w_158 * (w_140 * w_157 + w_141 * w_160 + w_143 * w_159 - w_145 * w_189)
            - w_167 * w_172 - w_204 - w_169 * w_173 - a2_on_platform_z * w_205;
        let w_207 = S::from_f64(2.0)
            * (w_170 * (w_187 / w_163_squared)
                + (platform_q0_dot * w_197 + platform_q1_dot * w_200
                    + platform_q2_dot * w_203 - platform_q3_dot * w_206) / w_163);
        let w_208 = w_207
            + (platform_x_dot * w_166 + platform_y_dot * w_167 + platform_z_dot * w_169)
                / w_163
            - w_170
                * ((platform_x_dot * w_158 + platform_y_dot * w_161
                    + platform_z_dot * a2_on_platform_z) / w_163_squared);
        let w_209 = sin_w * w_154;
        let w_210 = w_155 * w_7;
        let w_211 = self.r * cos_b1_head_angle;
        let w_212 = w_15 * sin_b1_head_angle;
        let w_213 = platform_x - self.R * cos_b1_foot_angle - w_13 * w_211
            + w_20 * w_212;
        let w_214 = w_15 * cos_b1_head_angle;
        let w_215 = self.r * sin_b1_head_angle;
        let w_216 = platform_y - self.R * sin_b1_foot_angle + w_24 * w_214
            - w_26 * w_215;
        let w_217 = w_29 * w_214 + w_30 * w_212;
        let b1_on_platform_z = platform_z + w_11 * w_217;
        let w_218 = w_213 * w_213 + w_216 * w_216 + b1_on_platform_z * b1_on_platform_z;
        let w_219 = w_40 * cos_b1_head_angle;
        let w_220 = w_40 * sin_b1_head_angle;
        let w_221 = platform_x_dot + w_39 * w_219 - w_43 * w_220 - w_49 * w_212;
        let w_222 = platform_y_dot + w_52 * w_214 - w_53 * w_219 + w_55 * w_220;
        let w_223 = w_57 * w_212 - w_58 * w_214;
        let w_224 = platform_z_dot - w_11_squared * w_36 * (w_29 * w_219 + w_30 * w_220)
            + w_11 * w_223;
        let w_243 = w_38 * w_219 + w_48 * w_212;
        let w_225 = w_213 * w_221 + w_216 * w_222 + b1_on_platform_z * w_224;
        let w_226 = w_62 * w_215 + w_64 * w_214 + w_66 * w_212;
        let w_227 = w_62 * w_211 - w_68 * w_214 - w_70 * w_212;
        let w_228 = w_11 * (platform_q2 * w_215 + platform_q1 * w_211) - w_65 * w_217;
        let w_229 = w_10 * w_214 - w_19 * w_212;
        let w_230 = platform_q0 * w_11_squared * w_229 - w_74 * w_215;
        let w_231 = w_25 * w_212 - w_23 * w_214;
        let w_232 = platform_q0 * w_11_squared * w_231 + w_74 * w_211;
        let w_233 = w_11 * (platform_q2 * w_211 - platform_q1 * w_215) + w_78 * w_217;
        let w_234 = w_80 * w_229 + w_81 * w_215;
        let w_235 = w_81 * w_211 - w_83 * w_214 - w_84 * w_212;
        let w_236 = w_11 * (platform_q3 * w_211 + platform_q0 * w_215) - w_80 * w_217;
        let w_237 = platform_q1_dot
            * (w_213 * w_234 + w_216 * w_235 + b1_on_platform_z * w_236);
        let w_238 = w_88 * w_215 - w_89 * w_214 - w_91 * w_212;
        let w_239 = w_88 * w_211 + w_90 * w_231;
        let w_240 = w_11 * (platform_q3 * w_215 - platform_q0 * w_211) - w_90 * w_217;
        let w_241 = platform_q2_dot
            * (w_213 * w_238 + w_216 * w_239 + b1_on_platform_z * w_240);
        let w_242 = platform_q3_dot
            * (w_213 * w_226 - w_216 * w_227 - b1_on_platform_z * w_228)
            - platform_q0_dot
                * (w_213 * w_230 + w_216 * w_232 - b1_on_platform_z * w_233) - w_237
            - w_241;
        let w_218_squared = w_218 * w_218;
        let w_244 = w_100 * sin_b1_head_angle;
        let w_245 = w_100 * cos_b1_head_angle;
        let w_246 = w_19 * w_244 - w_10 * w_245;
        let w_247 = w_213
            * (w_11_squared
                * (platform_q0 * w_243 + platform_q0_dot * w_229 + w_98 * w_212)
                + platform_q0 * w_36 * w_99 * w_246 - w_104 * w_215);
        let w_253 = w_213
            * (w_11_squared
                * (platform_q1_dot * w_229 + platform_q1 * w_243 - w_113 * w_212)
                + w_115 * w_246 + w_116 * w_215);
        let w_248 = w_23 * w_245 - w_25 * w_244;
        let w_249 = w_216
            * (w_11_squared * (platform_q0_dot * w_231 - w_106 * w_214 + w_107 * w_220)
                + platform_q0 * w_36 * w_99 * w_248 + w_104 * w_211);
        let w_256 = w_216
            * (w_11_squared * (platform_q2_dot * w_231 - w_134 * w_214 + w_135 * w_220)
                + w_128 * w_211 + w_132 * w_248);
        let w_250 = w_11_squared
            * (w_36 * (platform_q1 * w_212 - platform_q2 * w_214)
                + platform_q0_dot * w_217 + platform_q0 * w_223);
        let w_251 = w_29 * w_245 + w_30 * w_244;
        let w_252 = w_221 * w_230 + w_247 + w_222 * w_232 + w_249 - w_224 * w_233
            - b1_on_platform_z
                * (w_250 - platform_q0 * w_36 * w_99 * w_251
                    + w_11 * (platform_q2_dot * w_211 - platform_q1_dot * w_215));
        let w_254 = w_11 * (platform_q3_dot * w_211 + platform_q0_dot * w_215)
            - w_11_squared
                * (w_36 * (platform_q3 * w_214 + platform_q0 * w_212)
                    + platform_q1_dot * w_217 + platform_q1 * w_223) + w_115 * w_251;
        let w_255 = w_221 * w_234 + w_253 + w_222 * w_235
            + w_216 * (w_116 * w_211 - w_118 * w_214 + w_119 * w_245 - w_123 * w_212)
            + w_224 * w_236 + b1_on_platform_z * w_254;
        let w_259 = w_216
            * (w_141 * w_211 - w_146 * w_214 + w_147 * w_245 - w_148 * w_212);
        let w_257 = w_11_squared
            * (w_36 * (platform_q0 * w_214 - platform_q3 * w_212)
                - platform_q2_dot * w_217 - platform_q2 * w_223)
            + w_11 * (platform_q3_dot * w_215 - platform_q0_dot * w_211) + w_132 * w_251;
        let w_258 = w_221 * w_238
            + w_213 * (w_127 * w_212 + w_128 * w_215 - w_131 * w_214 + w_133 * w_244)
            + w_222 * w_239 + w_256 + w_224 * w_240 + b1_on_platform_z * w_257;
        let w_260 = w_11 * (platform_q2_dot * w_215 + platform_q1_dot * w_211)
            - w_11_squared
                * (w_36 * (platform_q2 * w_212 + platform_q1 * w_214)
                    + platform_q3_dot * w_217 + platform_q3 * w_223) + w_144 * w_251;
        let w_261 = w_221 * w_226
            + w_213 * (w_140 * w_212 + w_141 * w_215 + w_143 * w_214 - w_145 * w_244)
            - w_222 * w_227 - w_259 - w_224 * w_228 - b1_on_platform_z * w_260;
        let w_262 = S::from_f64(2.0)
            * (w_225 * (w_242 / w_218_squared)
                + (platform_q0_dot * w_252 + platform_q1_dot * w_255
                    + platform_q2_dot * w_258 - platform_q3_dot * w_261) / w_218);
        let w_263 = w_262
            + (platform_x_dot * w_221 + platform_y_dot * w_222 + platform_z_dot * w_224)
                / w_218
            - w_225
                * ((platform_x_dot * w_213 + platform_y_dot * w_216
                    + platform_z_dot * b1_on_platform_z) / w_218_squared);
        let w_264 = self.r * cos_b2_head_angle;
        let w_265 = w_15 * sin_b2_head_angle;
        let w_266 = platform_x - self.R * cos_b2_foot_angle - w_13 * w_264
            + w_20 * w_265;
        let w_267 = w_15 * cos_b2_head_angle;
        let w_268 = self.r * sin_b2_head_angle;
        let w_269 = platform_y - self.R * sin_b2_foot_angle + w_24 * w_267
            - w_26 * w_268;
        let w_270 = w_29 * w_267 + w_30 * w_265;
        let b2_on_platform_z = platform_z + w_11 * w_270;
        let w_271 = w_266 * w_266 + w_269 * w_269 + b2_on_platform_z * b2_on_platform_z;
        let w_272 = w_40 * cos_b2_head_angle;
        let w_273 = w_40 * sin_b2_head_angle;
        let w_274 = platform_x_dot + w_39 * w_272 - w_43 * w_273 - w_49 * w_265;
        let w_275 = platform_y_dot + w_52 * w_267 - w_53 * w_272 + w_55 * w_273;
        let w_276 = w_57 * w_265 - w_58 * w_267;
        let w_277 = platform_z_dot - w_11_squared * w_36 * (w_29 * w_272 + w_30 * w_273)
            + w_11 * w_276;
        let w_296 = w_38 * w_272 + w_48 * w_265;
        let w_278 = w_266 * w_274 + w_269 * w_275 + b2_on_platform_z * w_277;
        let w_279 = w_62 * w_268 + w_64 * w_267 + w_66 * w_265;
        let w_280 = w_62 * w_264 - w_68 * w_267 - w_70 * w_265;
        let w_281 = w_11 * (platform_q2 * w_268 + platform_q1 * w_264) - w_65 * w_270;
        let w_282 = w_10 * w_267 - w_19 * w_265;
        let w_283 = platform_q0 * w_11_squared * w_282 - w_74 * w_268;
        let w_284 = w_25 * w_265 - w_23 * w_267;
        let w_285 = platform_q0 * w_11_squared * w_284 + w_74 * w_264;
        let w_286 = w_11 * (platform_q2 * w_264 - platform_q1 * w_268) + w_78 * w_270;
        let w_287 = w_80 * w_282 + w_81 * w_268;
        let w_288 = w_81 * w_264 - w_83 * w_267 - w_84 * w_265;
        let w_289 = w_11 * (platform_q3 * w_264 + platform_q0 * w_268) - w_80 * w_270;
        let w_290 = platform_q1_dot
            * (w_266 * w_287 + w_269 * w_288 + b2_on_platform_z * w_289);
        let w_291 = w_88 * w_268 - w_89 * w_267 - w_91 * w_265;
        let w_292 = w_88 * w_264 + w_90 * w_284;
        let w_293 = w_11 * (platform_q3 * w_268 - platform_q0 * w_264) - w_90 * w_270;
        let w_294 = platform_q2_dot
            * (w_266 * w_291 + w_269 * w_292 + b2_on_platform_z * w_293);
        let w_295 = platform_q3_dot
            * (w_266 * w_279 - w_269 * w_280 - b2_on_platform_z * w_281)
            - platform_q0_dot
                * (w_266 * w_283 + w_269 * w_285 - b2_on_platform_z * w_286) - w_290
            - w_294;
        let w_271_squared = w_271 * w_271;
        let w_297 = w_100 * sin_b2_head_angle;
        let w_298 = w_100 * cos_b2_head_angle;
        let w_299 = w_19 * w_297 - w_10 * w_298;
        let w_300 = w_266
            * (w_11_squared
                * (platform_q0 * w_296 + platform_q0_dot * w_282 + w_98 * w_265)
                + platform_q0 * w_36 * w_99 * w_299 - w_104 * w_268);
        let w_306 = w_266
            * (w_11_squared
                * (platform_q1_dot * w_282 + platform_q1 * w_296 - w_113 * w_265)
                + w_115 * w_299 + w_116 * w_268);
        let w_301 = w_23 * w_298 - w_25 * w_297;
        let w_302 = w_269
            * (w_11_squared * (platform_q0_dot * w_284 - w_106 * w_267 + w_107 * w_273)
                + platform_q0 * w_36 * w_99 * w_301 + w_104 * w_264);
        let w_309 = w_269
            * (w_11_squared * (platform_q2_dot * w_284 - w_134 * w_267 + w_135 * w_273)
                + w_128 * w_264 + w_132 * w_301);
        let w_303 = w_11_squared
            * (w_36 * (platform_q1 * w_265 - platform_q2 * w_267)
                + platform_q0_dot * w_270 + platform_q0 * w_276);
        let w_304 = w_29 * w_298 + w_30 * w_297;
        let w_305 = w_274 * w_283 + w_300 + w_275 * w_285 + w_302 - w_277 * w_286
            - b2_on_platform_z
                * (w_303 - platform_q0 * w_36 * w_99 * w_304
                    + w_11 * (platform_q2_dot * w_264 - platform_q1_dot * w_268));
        let w_307 = w_11 * (platform_q3_dot * w_264 + platform_q0_dot * w_268)
            - w_11_squared
                * (w_36 * (platform_q3 * w_267 + platform_q0 * w_265)
                    + platform_q1_dot * w_270 + platform_q1 * w_276) + w_115 * w_304;
        let w_308 = w_274 * w_287 + w_306 + w_275 * w_288
            + w_269 * (w_116 * w_264 - w_118 * w_267 + w_119 * w_298 - w_123 * w_265)
            + w_277 * w_289 + b2_on_platform_z * w_307;
        let w_312 = w_269
            * (w_141 * w_264 - w_146 * w_267 + w_147 * w_298 - w_148 * w_265);
        let w_310 = w_11_squared
            * (w_36 * (platform_q0 * w_267 - platform_q3 * w_265)
                - platform_q2_dot * w_270 - platform_q2 * w_276)
            + w_11 * (platform_q3_dot * w_268 - platform_q0_dot * w_264) + w_132 * w_304;
        let w_311 = w_274 * w_291
            + w_266 * (w_127 * w_265 + w_128 * w_268 - w_131 * w_267 + w_133 * w_297)
            + w_275 * w_292 + w_309 + w_277 * w_293 + b2_on_platform_z * w_310;
        let w_313 = w_11 * (platform_q2_dot * w_268 + platform_q1_dot * w_264)
            - w_11_squared
                * (w_36 * (platform_q2 * w_265 + platform_q1 * w_267)
                    + platform_q3_dot * w_270 + platform_q3 * w_276) + w_144 * w_304;
        let w_314 = w_274 * w_279
            + w_266 * (w_140 * w_265 + w_141 * w_268 + w_143 * w_267 - w_145 * w_297)
            - w_275 * w_280 - w_312 - w_277 * w_281 - b2_on_platform_z * w_313;
        let w_315 = S::from_f64(2.0)
            * (w_278 * (w_295 / w_271_squared)
                + (platform_q0_dot * w_305 + platform_q1_dot * w_308
                    + platform_q2_dot * w_311 - platform_q3_dot * w_314) / w_271);
        let w_316 = w_315
            + (platform_x_dot * w_274 + platform_y_dot * w_275 + platform_z_dot * w_277)
                / w_271
            - w_278
                * ((platform_x_dot * w_266 + platform_y_dot * w_269
                    + platform_z_dot * b2_on_platform_z) / w_271_squared);
        let w_317 = w_155 * w_8;
        let w_318 = self.r * cos_c1_head_angle;
        let w_319 = w_15 * sin_c1_head_angle;
        let w_320 = platform_x - self.R * cos_c1_foot_angle - w_13 * w_318
            + w_20 * w_319;
        let w_321 = w_15 * cos_c1_head_angle;
        let w_322 = self.r * sin_c1_head_angle;
        let w_323 = platform_y - self.R * sin_c1_foot_angle + w_24 * w_321
            - w_26 * w_322;
        let w_324 = w_29 * w_321 + w_30 * w_319;
        let c1_on_platform_z = platform_z + w_11 * w_324;
        let w_325 = w_320 * w_320 + w_323 * w_323 + c1_on_platform_z * c1_on_platform_z;
        let w_326 = w_40 * cos_c1_head_angle;
        let w_327 = w_40 * sin_c1_head_angle;
        let w_328 = platform_x_dot + w_39 * w_326 - w_43 * w_327 - w_49 * w_319;
        let w_329 = platform_y_dot + w_52 * w_321 - w_53 * w_326 + w_55 * w_327;
        let w_330 = w_57 * w_319 - w_58 * w_321;
        let w_331 = platform_z_dot - w_11_squared * w_36 * (w_29 * w_326 + w_30 * w_327)
            + w_11 * w_330;
        let w_350 = w_38 * w_326 + w_48 * w_319;
        let w_332 = w_320 * w_328 + w_323 * w_329 + c1_on_platform_z * w_331;
        let w_333 = w_62 * w_322 + w_64 * w_321 + w_66 * w_319;
        let w_334 = w_62 * w_318 - w_68 * w_321 - w_70 * w_319;
        let w_335 = w_11 * (platform_q2 * w_322 + platform_q1 * w_318) - w_65 * w_324;
        let w_336 = w_10 * w_321 - w_19 * w_319;
        let w_337 = platform_q0 * w_11_squared * w_336 - w_74 * w_322;
        let w_338 = w_25 * w_319 - w_23 * w_321;
        let w_339 = platform_q0 * w_11_squared * w_338 + w_74 * w_318;
        let w_340 = w_11 * (platform_q2 * w_318 - platform_q1 * w_322) + w_78 * w_324;
        let w_341 = w_80 * w_336 + w_81 * w_322;
        let w_342 = w_81 * w_318 - w_83 * w_321 - w_84 * w_319;
        let w_343 = w_11 * (platform_q3 * w_318 + platform_q0 * w_322) - w_80 * w_324;
        let w_344 = platform_q1_dot
            * (w_320 * w_341 + w_323 * w_342 + c1_on_platform_z * w_343);
        let w_345 = w_88 * w_322 - w_89 * w_321 - w_91 * w_319;
        let w_346 = w_88 * w_318 + w_90 * w_338;
        let w_347 = w_11 * (platform_q3 * w_322 - platform_q0 * w_318) - w_90 * w_324;
        let w_348 = platform_q2_dot
            * (w_320 * w_345 + w_323 * w_346 + c1_on_platform_z * w_347);
        let w_349 = platform_q3_dot
            * (w_320 * w_333 - w_323 * w_334 - c1_on_platform_z * w_335)
            - platform_q0_dot
                * (w_320 * w_337 + w_323 * w_339 - c1_on_platform_z * w_340) - w_344
            - w_348;
        let w_325_squared = w_325 * w_325;
        let w_351 = w_100 * sin_c1_head_angle;
        let w_352 = w_100 * cos_c1_head_angle;
        let w_353 = w_19 * w_351 - w_10 * w_352;
        let w_354 = w_320
            * (w_11_squared
                * (platform_q0 * w_350 + platform_q0_dot * w_336 + w_98 * w_319)
                + platform_q0 * w_36 * w_99 * w_353 - w_104 * w_322);
        let w_360 = w_320
            * (w_11_squared
                * (platform_q1_dot * w_336 + platform_q1 * w_350 - w_113 * w_319)
                + w_115 * w_353 + w_116 * w_322);
        let w_355 = w_23 * w_352 - w_25 * w_351;
        let w_356 = w_323
            * (w_11_squared * (platform_q0_dot * w_338 - w_106 * w_321 + w_107 * w_327)
                + platform_q0 * w_36 * w_99 * w_355 + w_104 * w_318);
        let w_363 = w_323
            * (w_11_squared * (platform_q2_dot * w_338 - w_134 * w_321 + w_135 * w_327)
                + w_128 * w_318 + w_132 * w_355);
        let w_357 = w_11_squared
            * (w_36 * (platform_q1 * w_319 - platform_q2 * w_321)
                + platform_q0_dot * w_324 + platform_q0 * w_330);
        let w_358 = w_29 * w_352 + w_30 * w_351;
        let w_359 = w_328 * w_337 + w_354 + w_329 * w_339 + w_356 - w_331 * w_340
            - c1_on_platform_z
                * (w_357 - platform_q0 * w_36 * w_99 * w_358
                    + w_11 * (platform_q2_dot * w_318 - platform_q1_dot * w_322));
        let w_361 = w_11 * (platform_q3_dot * w_318 + platform_q0_dot * w_322)
            - w_11_squared
                * (w_36 * (platform_q3 * w_321 + platform_q0 * w_319)
                    + platform_q1_dot * w_324 + platform_q1 * w_330) + w_115 * w_358;
        let w_362 = w_328 * w_341 + w_360 + w_329 * w_342
            + w_323 * (w_116 * w_318 - w_118 * w_321 + w_119 * w_352 - w_123 * w_319)
            + w_331 * w_343 + c1_on_platform_z * w_361;
        let w_366 = w_323
            * (w_141 * w_318 - w_146 * w_321 + w_147 * w_352 - w_148 * w_319);
        let w_364 = w_11_squared
            * (w_36 * (platform_q0 * w_321 - platform_q3 * w_319)
                - platform_q2_dot * w_324 - platform_q2 * w_330)
            + w_11 * (platform_q3_dot * w_322 - platform_q0_dot * w_318) + w_132 * w_358;
        let w_365 = w_328 * w_345
            + w_320 * (w_127 * w_319 + w_128 * w_322 - w_131 * w_321 + w_133 * w_351)
            + w_329 * w_346 + w_363 + w_331 * w_347 + c1_on_platform_z * w_364;
        let w_367 = w_11 * (platform_q2_dot * w_322 + platform_q1_dot * w_318)
            - w_11_squared
                * (w_36 * (platform_q2 * w_319 + platform_q1 * w_321)
                    + platform_q3_dot * w_324 + platform_q3 * w_330) + w_144 * w_358;
        let w_368 = w_328 * w_333
            + w_320 * (w_140 * w_319 + w_141 * w_322 + w_143 * w_321 - w_145 * w_351)
            - w_329 * w_334 - w_366 - w_331 * w_335 - c1_on_platform_z * w_367;
        let w_369 = S::from_f64(2.0)
            * (w_332 * (w_349 / w_325_squared)
                + (platform_q0_dot * w_359 + platform_q1_dot * w_362
                    + platform_q2_dot * w_365 - platform_q3_dot * w_368) / w_325);
        let w_370 = w_369
            + (platform_x_dot * w_328 + platform_y_dot * w_329 + platform_z_dot * w_331)
                / w_325
            - w_332
                * ((platform_x_dot * w_320 + platform_y_dot * w_323
                    + platform_z_dot * c1_on_platform_z) / w_325_squared);
        let w_371 = self.r * cos_c2_head_angle;
        let w_372 = w_15 * sin_c2_head_angle;
        let w_373 = platform_x - self.R * cos_c2_foot_angle - w_13 * w_371
            + w_20 * w_372;
        let w_374 = w_15 * cos_c2_head_angle;
        let w_383 = w_57 * w_372 - w_58 * w_374;
        let w_387 = w_62 * w_371 - w_68 * w_374 - w_70 * w_372;
        let w_395 = w_81 * w_371 - w_83 * w_374 - w_84 * w_372;
        let w_375 = self.r * sin_c2_head_angle;
        let w_376 = platform_y - self.R * sin_c2_foot_angle + w_24 * w_374
            - w_26 * w_375;
        let w_386 = w_62 * w_375 + w_64 * w_374 + w_66 * w_372;
        let w_398 = w_88 * w_375 - w_89 * w_374 - w_91 * w_372;
        let w_377 = w_29 * w_374 + w_30 * w_372;
        let w_388 = w_11 * (platform_q2 * w_375 + platform_q1 * w_371) - w_65 * w_377;
        let w_393 = w_11 * (platform_q2 * w_371 - platform_q1 * w_375) + w_78 * w_377;
        let c2_on_platform_z = platform_z + w_11 * w_377;
        let w_378 = w_373 * w_373 + w_376 * w_376 + c2_on_platform_z * c2_on_platform_z;
        let w_379 = w_40 * cos_c2_head_angle;
        let w_380 = w_40 * sin_c2_head_angle;
        let w_381 = platform_x_dot + w_39 * w_379 - w_43 * w_380 - w_49 * w_372;
        let w_382 = platform_y_dot + w_52 * w_374 - w_53 * w_379 + w_55 * w_380;
        let w_403 = w_38 * w_379 + w_48 * w_372;
        let w_384 = platform_z_dot - w_11_squared * w_36 * (w_29 * w_379 + w_30 * w_380)
            + w_11 * w_383;
        let w_385 = w_373 * w_381 + w_376 * w_382 + c2_on_platform_z * w_384;
        let w_389 = w_10 * w_374 - w_19 * w_372;
        let w_394 = w_80 * w_389 + w_81 * w_375;
        let w_396 = w_11 * (platform_q3 * w_371 + platform_q0 * w_375) - w_80 * w_377;
        let w_390 = platform_q0 * w_11_squared * w_389 - w_74 * w_375;
        let w_391 = w_25 * w_372 - w_23 * w_374;
        let w_392 = platform_q0 * w_11_squared * w_391 + w_74 * w_371;
        let w_399 = w_88 * w_371 + w_90 * w_391;
        let w_400 = w_11 * (platform_q3 * w_375 - platform_q0 * w_371) - w_90 * w_377;
        let w_397 = platform_q1_dot
            * (w_373 * w_394 + w_376 * w_395 + c2_on_platform_z * w_396);
        let w_401 = platform_q2_dot
            * (w_373 * w_398 + w_376 * w_399 + c2_on_platform_z * w_400);
        let w_402 = platform_q3_dot
            * (w_373 * w_386 - w_376 * w_387 - c2_on_platform_z * w_388)
            - platform_q0_dot
                * (w_373 * w_390 + w_376 * w_392 - c2_on_platform_z * w_393) - w_397
            - w_401;
        let w_378_squared = w_378 * w_378;
        let w_404 = w_100 * sin_c2_head_angle;
        let w_405 = w_100 * cos_c2_head_angle;
        let w_406 = w_19 * w_404 - w_10 * w_405;
        let w_407 = w_373
            * (w_11_squared
                * (platform_q0 * w_403 + platform_q0_dot * w_389 + w_98 * w_372)
                + platform_q0 * w_36 * w_99 * w_406 - w_104 * w_375);
        let w_413 = w_373
            * (w_11_squared
                * (platform_q1_dot * w_389 + platform_q1 * w_403 - w_113 * w_372)
                + w_115 * w_406 + w_116 * w_375);
        let w_408 = w_23 * w_405 - w_25 * w_404;
        let w_409 = w_376
            * (w_11_squared * (platform_q0_dot * w_391 - w_106 * w_374 + w_107 * w_380)
                + platform_q0 * w_36 * w_99 * w_408 + w_104 * w_371);
        let w_416 = w_376
            * (w_11_squared * (platform_q2_dot * w_391 - w_134 * w_374 + w_135 * w_380)
                + w_128 * w_371 + w_132 * w_408);
        let w_411 = w_29 * w_405 + w_30 * w_404;
        let w_414 = w_11 * (platform_q3_dot * w_371 + platform_q0_dot * w_375)
            - w_11_squared
                * (w_36 * (platform_q3 * w_374 + platform_q0 * w_372)
                    + platform_q1_dot * w_377 + platform_q1 * w_383) + w_115 * w_411;
        let w_415 = w_381 * w_394 + w_413 + w_382 * w_395
            + w_376 * (w_116 * w_371 - w_118 * w_374 + w_119 * w_405 - w_123 * w_372)
            + w_384 * w_396 + c2_on_platform_z * w_414;
        let w_419 = w_376
            * (w_141 * w_371 - w_146 * w_374 + w_147 * w_405 - w_148 * w_372);
        let w_417 = w_11_squared
            * (w_36 * (platform_q0 * w_374 - platform_q3 * w_372)
                - platform_q2_dot * w_377 - platform_q2 * w_383)
            + w_11 * (platform_q3_dot * w_375 - platform_q0_dot * w_371) + w_132 * w_411;
        let w_418 = w_381 * w_398
            + w_373 * (w_127 * w_372 + w_128 * w_375 - w_131 * w_374 + w_133 * w_404)
            + w_382 * w_399 + w_416 + w_384 * w_400 + c2_on_platform_z * w_417;
        let w_420 = w_11 * (platform_q2_dot * w_375 + platform_q1_dot * w_371)
            - w_11_squared
                * (w_36 * (platform_q2 * w_372 + platform_q1 * w_374)
                    + platform_q3_dot * w_377 + platform_q3 * w_383) + w_144 * w_411;
        let w_410 = w_11_squared
            * (w_36 * (platform_q1 * w_372 - platform_q2 * w_374)
                + platform_q0_dot * w_377 + platform_q0 * w_383);
        let w_412 = w_381 * w_390 + w_407 + w_382 * w_392 + w_409 - w_384 * w_393
            - c2_on_platform_z
                * (w_410 - platform_q0 * w_36 * w_99 * w_411
                    + w_11 * (platform_q2_dot * w_371 - platform_q1_dot * w_375));
        let w_421 = w_381 * w_386
            + w_373 * (w_140 * w_372 + w_141 * w_375 + w_143 * w_374 - w_145 * w_404)
            - w_382 * w_387 - w_419 - w_384 * w_388 - c2_on_platform_z * w_420;
        let w_422 = S::from_f64(2.0)
            * (w_385 * (w_402 / w_378_squared)
                + (platform_q0_dot * w_412 + platform_q1_dot * w_415
                    + platform_q2_dot * w_418 - platform_q3_dot * w_421) / w_378);
        let w_423 = w_422
            + (platform_x_dot * w_381 + platform_y_dot * w_382 + platform_z_dot * w_384)
                / w_378
            - w_385
                * ((platform_x_dot * w_373 + platform_y_dot * w_376
                    + platform_z_dot * c2_on_platform_z) / w_378_squared);
        [
            S::from_f64(2.0)
                * (platform_q0_dot * platform_q0_dot + platform_q1_dot * platform_q1_dot
                    + platform_q2_dot * platform_q2_dot
                    + platform_q3_dot * platform_q3_dot),
            w_32.sqrt() * w_153 + sin_w * (w_154 + w_155),
            w_163.sqrt() * w_208 + w_209 - w_210,
            w_209 + w_210 + w_218.sqrt() * w_263,
            w_209 + w_271.sqrt() * w_316 - w_317,
            w_209 + w_317 + w_325.sqrt() * w_370,
            w_209 + w_378.sqrt() * w_423 - w_155 * w_9,
        ]
    }
    /// `C` (7), `C_q` (7 x 7) and `C_t` (7) together, in SI units, for projection.
    ///
    /// Operations: 304 additions, 525 multiplications, 43 divisions, 16 sine-cosine pairs, 6 square roots.
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
        let a2_head_angle = w + self.head;
        let w_2 = t * self.w;
        let w_3 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_3 - self.foot;
        let w_4 = w_2 + w_3;
        let b1_foot_angle = w_3 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_5 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333);
        let b2_foot_angle = w_5 - self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let w_6 = w_2 + w_5;
        let c1_foot_angle = w_5 + self.foot;
        let w_7 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_7 - self.head;
        let c2_head_angle = w_7 + self.head;
        let w_8 = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI);
        let c2_foot_angle = w_8 - self.foot;
        let w_9 = w_2 + w_8;
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
        let w_23 = w_17 + w_18;
        let w_20 = w_11 * w_19;
        let w_21 = platform_x - self.R * cos_foot - w_13 * w_14 + w_16 * w_20;
        let w_22 = cos_a1_head_angle * w_15;
        let w_24 = w_11 * w_23;
        let w_25 = platform_q1_squared + platform_q3_squared;
        let w_26 = w_12 * w_25 - S::from_f64(1.0);
        let w_27 = self.r * sin_a1_head_angle;
        let w_28 = platform_y - self.R * sin_foot + w_22 * w_24 - w_26 * w_27;
        let w_29 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_30 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let w_31 = w_22 * w_29 + w_16 * w_30;
        let a1_on_platform_z = platform_z + w_11 * w_31;
        let w_32 = w_21 * w_21 + w_28 * w_28 + a1_on_platform_z * a1_on_platform_z;
        let sqrt_w_32 = w_32.sqrt();
        let w_33 = self.r * cos_a2_head_angle;
        let w_34 = w_15 * sin_a2_head_angle;
        let w_35 = platform_x - self.R * cos_a2_foot_angle - w_13 * w_33 + w_20 * w_34;
        let w_36 = w_15 * cos_a2_head_angle;
        let w_37 = self.r * sin_a2_head_angle;
        let w_38 = platform_y - self.R * sin_a2_foot_angle + w_24 * w_36 - w_26 * w_37;
        let w_39 = w_29 * w_36 + w_30 * w_34;
        let a2_on_platform_z = platform_z + w_11 * w_39;
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
        let b1_on_platform_z = platform_z + w_11 * w_49;
        let w_50 = w_45 * w_45 + w_48 * w_48 + b1_on_platform_z * b1_on_platform_z;
        let sqrt_w_50 = w_50.sqrt();
        let w_51 = self.r * cos_b2_head_angle;
        let w_52 = w_15 * sin_b2_head_angle;
        let w_53 = platform_x - self.R * cos_b2_foot_angle - w_13 * w_51 + w_20 * w_52;
        let w_54 = w_15 * cos_b2_head_angle;
        let w_55 = self.r * sin_b2_head_angle;
        let w_56 = platform_y - self.R * sin_b2_foot_angle + w_24 * w_54 - w_26 * w_55;
        let w_57 = w_29 * w_54 + w_30 * w_52;
        let b2_on_platform_z = platform_z + w_11 * w_57;
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
        let c1_on_platform_z = platform_z + w_11 * w_66;
        let w_67 = w_62 * w_62 + w_65 * w_65 + c1_on_platform_z * c1_on_platform_z;
        let sqrt_w_67 = w_67.sqrt();
        let w_68 = self.r * cos_c2_head_angle;
        let w_69 = w_15 * sin_c2_head_angle;
        let w_70 = platform_x - self.R * cos_c2_foot_angle - w_13 * w_68 + w_20 * w_69;
        let w_71 = w_15 * cos_c2_head_angle;
        let w_74 = w_29 * w_71 + w_30 * w_69;
        let w_72 = self.r * sin_c2_head_angle;
        let w_73 = platform_y - self.R * sin_c2_foot_angle + w_24 * w_71 - w_26 * w_72;
        let c2_on_platform_z = platform_z + w_11 * w_74;
        let w_75 = w_70 * w_70 + w_73 * w_73 + c2_on_platform_z * c2_on_platform_z;
        let sqrt_w_75 = w_75.sqrt();
        let w_11_squared = w_11 * w_11;
        let w_76 = w_10 * w_22 - w_19 * w_16;
        let w_77 = platform_q3 * w_11;
        let w_78 = w_16 * w_25 - w_23 * w_22;
        let w_79 = platform_q0 * w_11_squared;
        let w_80 = a1_on_platform_z
            * (w_11 * (platform_q2 * w_14 - platform_q1 * w_27) + w_31 * w_79);
        let w_81 = S::from_f64(2.0) * sqrt_w_32;
        let w_82 = platform_q1 * w_11_squared;
        let w_83 = platform_q2 * w_11;
        let w_84 = w_23 * w_82;
        let w_85 = w_11 - w_25 * w_11_squared;
        let w_86 = platform_q1 * w_85;
        let w_99 = platform_q3 * w_85;
        let w_87 = a1_on_platform_z
            * (w_11 * (platform_q3 * w_14 + platform_q0 * w_27) - w_31 * w_82);
        let w_88 = platform_q1 * w_11;
        let w_89 = w_11 - w_10 * w_11_squared;
        let w_90 = platform_q2 * w_89;
        let w_95 = platform_q3 * w_89;
        let w_91 = platform_q2 * w_11_squared;
        let w_92 = w_19 * w_91;
        let w_93 = a1_on_platform_z
            * (w_11 * (platform_q3 * w_27 - platform_q0 * w_14) - w_31 * w_91);
        let w_94 = platform_q0 * w_11;
        let w_96 = platform_q3 * w_11_squared;
        let w_100 = a1_on_platform_z
            * (w_11 * (platform_q2 * w_27 + platform_q1 * w_14) - w_31 * w_96);
        let w_97 = w_19 * w_96;
        let w_98 = w_23 * w_96;
        let w_101 = w_81
            * (w_21 * (w_27 * w_94 + w_22 * w_95 + w_16 * w_97)
                - w_28 * (w_14 * w_94 - w_22 * w_98 - w_16 * w_99) - w_100);
        let w_102 = w_10 * w_36 - w_19 * w_34;
        let w_103 = w_25 * w_34 - w_23 * w_36;
        let w_104 = a2_on_platform_z
            * (w_11 * (platform_q2 * w_33 - platform_q1 * w_37) + w_39 * w_79);
        let w_105 = S::from_f64(2.0) * sqrt_w_40;
        let w_106 = a2_on_platform_z
            * (w_11 * (platform_q3 * w_33 + platform_q0 * w_37) - w_39 * w_82);
        let w_107 = a2_on_platform_z
            * (w_11 * (platform_q3 * w_37 - platform_q0 * w_33) - w_39 * w_91);
        let w_108 = a2_on_platform_z
            * (w_11 * (platform_q2 * w_37 + platform_q1 * w_33) - w_39 * w_96);
        let w_109 = w_105
            * (w_35 * (w_37 * w_94 + w_36 * w_95 + w_34 * w_97)
                - w_38 * (w_33 * w_94 - w_36 * w_98 - w_34 * w_99) - w_108);
        let w_110 = w_10 * w_46 - w_19 * w_44;
        let w_111 = w_25 * w_44 - w_23 * w_46;
        let w_112 = b1_on_platform_z
            * (w_11 * (platform_q2 * w_43 - platform_q1 * w_47) + w_49 * w_79);
        let w_113 = S::from_f64(2.0) * sqrt_w_50;
        let w_114 = b1_on_platform_z
            * (w_11 * (platform_q3 * w_43 + platform_q0 * w_47) - w_49 * w_82);
        let w_115 = b1_on_platform_z
            * (w_11 * (platform_q3 * w_47 - platform_q0 * w_43) - w_49 * w_91);
        let w_116 = b1_on_platform_z
            * (w_11 * (platform_q2 * w_47 + platform_q1 * w_43) - w_49 * w_96);
        let w_117 = w_113
            * (w_45 * (w_47 * w_94 + w_46 * w_95 + w_44 * w_97)
                - w_48 * (w_43 * w_94 - w_46 * w_98 - w_44 * w_99) - w_116);
        let w_118 = w_10 * w_54 - w_19 * w_52;
        let w_119 = w_25 * w_52 - w_23 * w_54;
        let w_120 = b2_on_platform_z
            * (w_11 * (platform_q2 * w_51 - platform_q1 * w_55) + w_57 * w_79);
        let w_121 = S::from_f64(2.0) * sqrt_w_58;
        let w_122 = b2_on_platform_z
            * (w_11 * (platform_q3 * w_51 + platform_q0 * w_55) - w_57 * w_82);
        let w_123 = b2_on_platform_z
            * (w_11 * (platform_q3 * w_55 - platform_q0 * w_51) - w_57 * w_91);
        let w_124 = b2_on_platform_z
            * (w_11 * (platform_q2 * w_55 + platform_q1 * w_51) - w_57 * w_96);
        let w_125 = w_121
            * (w_53 * (w_55 * w_94 + w_54 * w_95 + w_52 * w_97)
                - w_56 * (w_51 * w_94 - w_54 * w_98 - w_52 * w_99) - w_124);
        let w_126 = w_10 * w_63 - w_19 * w_61;
        let w_134 = w_10 * w_71 - w_19 * w_69;
        let w_127 = w_25 * w_61 - w_23 * w_63;
        let w_135 = w_25 * w_69 - w_23 * w_71;
        let w_128 = c1_on_platform_z
            * (w_11 * (platform_q2 * w_60 - platform_q1 * w_64) + w_66 * w_79);
        let w_136 = c2_on_platform_z
            * (w_11 * (platform_q2 * w_68 - platform_q1 * w_72) + w_74 * w_79);
        let w_129 = S::from_f64(2.0) * sqrt_w_67;
        let w_130 = c1_on_platform_z
            * (w_11 * (platform_q3 * w_60 + platform_q0 * w_64) - w_66 * w_82);
        let w_131 = c1_on_platform_z
            * (w_11 * (platform_q3 * w_64 - platform_q0 * w_60) - w_66 * w_91);
        let w_132 = c1_on_platform_z
            * (w_11 * (platform_q2 * w_64 + platform_q1 * w_60) - w_66 * w_96);
        let w_133 = w_129
            * (w_62 * (w_64 * w_94 + w_63 * w_95 + w_61 * w_97)
                - w_65 * (w_60 * w_94 - w_63 * w_98 - w_61 * w_99) - w_132);
        let w_140 = c2_on_platform_z
            * (w_11 * (platform_q2 * w_72 + platform_q1 * w_68) - w_74 * w_96);
        let w_137 = S::from_f64(2.0) * sqrt_w_75;
        let w_141 = w_137
            * (w_70 * (w_72 * w_94 + w_71 * w_95 + w_69 * w_97)
                - w_73 * (w_68 * w_94 - w_71 * w_98 - w_69 * w_99) - w_140);
        let w_138 = c2_on_platform_z
            * (w_11 * (platform_q3 * w_68 + platform_q0 * w_72) - w_74 * w_82);
        let w_139 = c2_on_platform_z
            * (w_11 * (platform_q3 * w_72 - platform_q0 * w_68) - w_74 * w_91);
        let w_142 = self.heave * self.w;
        let w_143 = self.w * self.sway;
        let w_144 = w_143 * cos_w_4;
        let w_145 = cos_w_2 * w_142;
        let w_146 = w_143 * cos_w_6;
        sim_kernel::ConstraintLinearization {
            values: [
                platform_q0_squared - S::from_f64(1.0) + platform_q1_squared
                    + platform_q2_squared + platform_q3_squared,
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
                    (w_21 * (platform_q0 * w_11_squared * w_76 - w_27 * w_77)
                        + w_28 * (platform_q0 * w_11_squared * w_78 + w_14 * w_77)
                        - w_80) * w_81 / w_32,
                    w_81
                        * (w_21 * (w_76 * w_82 + w_27 * w_83)
                            + w_28 * (w_14 * w_83 - w_22 * w_84 - w_16 * w_86) + w_87)
                        / w_32,
                    w_81
                        * (w_21 * (w_27 * w_88 - w_22 * w_90 - w_16 * w_92)
                            + w_28 * (w_14 * w_88 + w_78 * w_91) + w_93) / w_32,
                    -(w_101 / w_32),
                ],
                [
                    w_35 * sqrt_w_40 / w_40,
                    w_38 * sqrt_w_40 / w_40,
                    a2_on_platform_z * sqrt_w_40 / w_40,
                    (w_35 * (platform_q0 * w_11_squared * w_102 - w_37 * w_77)
                        + w_38 * (platform_q0 * w_11_squared * w_103 + w_33 * w_77)
                        - w_104) * w_105 / w_40,
                    w_105
                        * (w_35 * (w_82 * w_102 + w_37 * w_83)
                            + w_38 * (w_33 * w_83 - w_36 * w_84 - w_34 * w_86) + w_106)
                        / w_40,
                    w_105
                        * (w_35 * (w_37 * w_88 - w_36 * w_90 - w_34 * w_92)
                            + w_38 * (w_33 * w_88 + w_91 * w_103) + w_107) / w_40,
                    -(w_109 / w_40),
                ],
                [
                    w_45 * sqrt_w_50 / w_50,
                    w_48 * sqrt_w_50 / w_50,
                    b1_on_platform_z * sqrt_w_50 / w_50,
                    (w_45 * (platform_q0 * w_11_squared * w_110 - w_47 * w_77)
                        + w_48 * (platform_q0 * w_11_squared * w_111 + w_43 * w_77)
                        - w_112) * w_113 / w_50,
                    w_113
                        * (w_45 * (w_82 * w_110 + w_47 * w_83)
                            + w_48 * (w_43 * w_83 - w_46 * w_84 - w_44 * w_86) + w_114)
                        / w_50,
                    w_113
                        * (w_45 * (w_47 * w_88 - w_46 * w_90 - w_44 * w_92)
                            + w_48 * (w_43 * w_88 + w_91 * w_111) + w_115) / w_50,
                    -(w_117 / w_50),
                ],
                [
                    w_53 * sqrt_w_58 / w_58,
                    w_56 * sqrt_w_58 / w_58,
                    b2_on_platform_z * sqrt_w_58 / w_58,
                    (w_53 * (platform_q0 * w_11_squared * w_118 - w_55 * w_77)
                        + w_56 * (platform_q0 * w_11_squared * w_119 + w_51 * w_77)
                        - w_120) * w_121 / w_58,
                    w_121
                        * (w_53 * (w_82 * w_118 + w_55 * w_83)
                            + w_56 * (w_51 * w_83 - w_54 * w_84 - w_52 * w_86) + w_122)
                        / w_58,
                    w_121
                        * (w_53 * (w_55 * w_88 - w_54 * w_90 - w_52 * w_92)
                            + w_56 * (w_51 * w_88 + w_91 * w_119) + w_123) / w_58,
                    -(w_125 / w_58),
                ],
                [
                    w_62 * sqrt_w_67 / w_67,
                    w_65 * sqrt_w_67 / w_67,
                    c1_on_platform_z * sqrt_w_67 / w_67,
                    (w_62 * (platform_q0 * w_11_squared * w_126 - w_64 * w_77)
                        + w_65 * (platform_q0 * w_11_squared * w_127 + w_60 * w_77)
                        - w_128) * w_129 / w_67,
                    w_129
                        * (w_62 * (w_82 * w_126 + w_64 * w_83)
                            + w_65 * (w_60 * w_83 - w_63 * w_84 - w_61 * w_86) + w_130)
                        / w_67,
                    w_129
                        * (w_62 * (w_64 * w_88 - w_63 * w_90 - w_61 * w_92)
                            + w_65 * (w_60 * w_88 + w_91 * w_127) + w_131) / w_67,
                    -(w_133 / w_67),
                ],
                [
                    w_70 * sqrt_w_75 / w_75,
                    w_73 * sqrt_w_75 / w_75,
                    c2_on_platform_z * sqrt_w_75 / w_75,
                    (w_70 * (platform_q0 * w_11_squared * w_134 - w_72 * w_77)
                        + w_73 * (platform_q0 * w_11_squared * w_135 + w_68 * w_77)
                        - w_136) * w_137 / w_75,
                    w_137
                        * (w_70 * (w_82 * w_134 + w_72 * w_83)
                            + w_73 * (w_68 * w_83 - w_71 * w_84 - w_69 * w_86) + w_138)
                        / w_75,
                    w_137
                        * (w_70 * (w_72 * w_88 - w_71 * w_90 - w_69 * w_92)
                            + w_73 * (w_68 * w_88 + w_91 * w_135) + w_139) / w_75,
                    -(w_141 / w_75),
                ],
            ],
            time_derivative: [
                S::from_f64(0.0),
                -(cos_w_2 * (w_142 + w_143)),
                w_144 - w_145,
                -(w_145 + w_144),
                w_146 - w_145,
                -(w_145 + w_146),
                w_143 * cos_w_9 - w_145,
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
            w + S::from_f64(0.6666666666666666) * S::from_f64(::core::f64::consts::PI),
            w + S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333),
            w + S::from_f64(::core::f64::consts::PI) * S::from_f64(2.0),
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
        let a2_head_angle = w + self.head;
        let w_2 = S::from_f64(::core::f64::consts::PI) * S::from_f64(0.6666666666666666);
        let a2_foot_angle = w_2 - self.foot;
        let b1_foot_angle = w_2 + self.foot;
        let b1_head_angle = S::from_f64(::core::f64::consts::PI) - self.head;
        let w_3 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.3333333333333333);
        let b2_foot_angle = w_3 - self.foot;
        let c1_foot_angle = w_3 + self.foot;
        let b2_head_angle = S::from_f64(::core::f64::consts::PI) + self.head;
        let w_4 = S::from_f64(::core::f64::consts::PI) * S::from_f64(1.6666666666666667);
        let c1_head_angle = w_4 - self.head;
        let c2_head_angle = w_4 + self.head;
        let c2_foot_angle = S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI)
            - self.foot;
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
        let w_15 = w_6 * (platform_q1_squared + platform_q3_squared) - S::from_f64(1.0);
        let w_8 = self.r * S::from_f64(2.0);
        let w_9 = sin_a1_head_angle * w_8;
        let w_10 = platform_q1 * platform_q2;
        let w_11 = platform_q0 * platform_q3;
        let w_12 = w_5 * (w_10 - w_11);
        let w_14 = w_5 * (w_10 + w_11);
        let a1_on_platform_x = platform_x - w_7 * self.r * cos_a1_head_angle
            + w_9 * w_12;
        let w_13 = cos_a1_head_angle * w_8;
        let a1_on_platform_y = platform_y + w_13 * w_14
            - w_15 * self.r * sin_a1_head_angle;
        let w_16 = platform_q1 * platform_q3 - platform_q0 * platform_q2;
        let w_17 = platform_q2 * platform_q3 + platform_q0 * platform_q1;
        let a1_on_platform_z = platform_z + w_5 * (w_13 * w_16 + w_9 * w_17);
        let a2_on_ground_x = self.R * cos_a2_foot_angle;
        let a2_on_ground_y = self.R * sin_a2_foot_angle;
        let w_18 = w_8 * sin_a2_head_angle;
        let a2_on_platform_x = platform_x - w_7 * self.r * cos_a2_head_angle
            + w_12 * w_18;
        let w_19 = w_8 * cos_a2_head_angle;
        let a2_on_platform_z = platform_z + w_5 * (w_16 * w_19 + w_17 * w_18);
        let a2_on_platform_y = platform_y + w_14 * w_19
            - w_15 * self.r * sin_a2_head_angle;
        let b1_on_ground_x = self.R * cos_b1_foot_angle;
        let b1_on_ground_y = self.R * sin_b1_foot_angle;
        let w_20 = w_8 * sin_b1_head_angle;
        let b1_on_platform_x = platform_x - w_7 * self.r * cos_b1_head_angle
            + w_12 * w_20;
        let w_21 = w_8 * cos_b1_head_angle;
        let b1_on_platform_z = platform_z + w_5 * (w_16 * w_21 + w_17 * w_20);
        let b1_on_platform_y = platform_y + w_14 * w_21
            - w_15 * self.r * sin_b1_head_angle;
        let b2_on_ground_x = self.R * cos_b2_foot_angle;
        let b2_on_ground_y = self.R * sin_b2_foot_angle;
        let w_22 = w_8 * sin_b2_head_angle;
        let b2_on_platform_x = platform_x - w_7 * self.r * cos_b2_head_angle
            + w_12 * w_22;
        let w_23 = w_8 * cos_b2_head_angle;
        let b2_on_platform_z = platform_z + w_5 * (w_16 * w_23 + w_17 * w_22);
        let b2_on_platform_y = platform_y + w_14 * w_23
            - w_15 * self.r * sin_b2_head_angle;
        let c1_on_ground_x = self.R * cos_c1_foot_angle;
        let c1_on_ground_y = self.R * sin_c1_foot_angle;
        let w_24 = w_8 * sin_c1_head_angle;
        let c1_on_platform_x = platform_x - w_7 * self.r * cos_c1_head_angle
            + w_12 * w_24;
        let w_25 = w_8 * cos_c1_head_angle;
        let c1_on_platform_z = platform_z + w_5 * (w_16 * w_25 + w_17 * w_24);
        let c1_on_platform_y = platform_y + w_14 * w_25
            - w_15 * self.r * sin_c1_head_angle;
        let c2_on_ground_x = self.R * cos_c2_foot_angle;
        let c2_on_ground_y = self.R * sin_c2_foot_angle;
        let w_26 = w_8 * sin_c2_head_angle;
        let c2_on_platform_x = platform_x - w_7 * self.r * cos_c2_head_angle
            + w_12 * w_26;
        let w_27 = w_8 * cos_c2_head_angle;
        let c2_on_platform_y = platform_y + w_14 * w_27
            - w_15 * self.r * sin_c2_head_angle;
        let c2_on_platform_z = platform_z + w_5 * (w_16 * w_27 + w_17 * w_26);
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
    /// Operations: 1358 additions, 2056 multiplications, 78 divisions, 4 sine-cosine pairs, 6 square roots.
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
        let platform_q1_squared = platform_q1 * platform_q1;
        let platform_q0_squared = platform_q0 * platform_q0;
        let platform_q2_squared = platform_q2 * platform_q2;
        let platform_q3_squared = platform_q3 * platform_q3;
        let w = S::from_f64(1.0)
            / (platform_q1_squared + platform_q0_squared + platform_q2_squared
                + platform_q3_squared);
        let w_squared = w * w;
        let w_2 = platform_q0 * platform_q2_dot;
        let w_3 = platform_q2 * platform_q0_dot;
        let w_4 = platform_q3 * platform_q1_dot;
        let w_5 = platform_q1 * platform_q3_dot;
        let w_6 = w_2 - w_3 - w_4 + w_5;
        let w_97 = w_2 + w_3 - w_4 - w_5;
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
        let w_96 = w_12 + w_13 + w_14 + w_15;
        let w_17 = platform_q1 * platform_q1_dot;
        let w_18 = platform_q2 * platform_q2_dot;
        let w_19 = platform_q3 * platform_q3_dot;
        let w_20 = platform_q0 * platform_q0_dot + w_17 + w_18 + w_19;
        let w_84 = w_18 + w_19;
        let w_93 = w_17 + w_19;
        let w_21 = self.A * w_20;
        let w_22 = w_squared * (w_6 * w_11 * self.k_45 - w_16 * w_21);
        let w_23 = w_squared * (w_11 * w_16 * self.k_46 - w_6 * w_21);
        let w_27 = w_11 * self.k_47;
        let w_24 = w * w_squared;
        let w_25 = w_20 * w_24;
        let w_26 = platform_q3 * w_25;
        let w_28 = platform_q0_dot * platform_q0_dot + platform_q1_dot * platform_q1_dot
            + platform_q2_dot * platform_q2_dot + platform_q3_dot * platform_q3_dot;
        let w_29 = self.k_3 * w_28;
        let rhs_platform_q0 = S::from_f64(8.0) * w
            * (platform_q1 * w_22 + platform_q2 * w_23) - w_26 * w_27
            - platform_q0 * w_29;
        let w_30 = platform_q2 * w_25;
        let w_31 = self.k_3 - w_squared * self.k;
        let w_32 = platform_q2 * w_squared;
        let mass_platform_q1_platform_q0 = platform_q1 * platform_q0 * w_31
            + platform_q3 * self.k_4 * w_32;
        let w_33 = self.k * (platform_q1_squared + platform_q2_squared);
        let mass_platform_q0_platform_q0 = w_squared
            * (w_33 + platform_q3_squared * self.k_2) + platform_q0_squared * self.k_3;
        let mass_platform_q3_platform_q3 = w_squared
            * (w_33 + platform_q0_squared * self.k_2) + platform_q3_squared * self.k_3;
        let w_36 = self.k * (platform_q0_squared + platform_q3_squared);
        let inverse_platform_q0 = S::from_f64(1.0) / mass_platform_q0_platform_q0;
        let l_platform_q1_platform_q0 = mass_platform_q1_platform_q0
            * inverse_platform_q0;
        let rhs_platform_q1 = S::from_f64(8.0) * w
            * (platform_q3 * w_23 - platform_q0 * w_22) + w_27 * w_30
            - platform_q1 * w_29 - rhs_platform_q0 * l_platform_q1_platform_q0;
        let w_34 = self.k_3 - w_squared * self.k_2;
        let w_35 = platform_q0 * platform_q3;
        let mass_platform_q3_platform_q0 = w_34 * w_35;
        let l_platform_q3_platform_q0 = mass_platform_q3_platform_q0
            * inverse_platform_q0;
        let mass_platform_q1_platform_q1 = w_squared
            * (w_36 + platform_q2_squared * self.k_2) + platform_q1_squared * self.k_3;
        let mass_platform_q2_platform_q2 = w_squared
            * (w_36 + platform_q1_squared * self.k_2) + platform_q2_squared * self.k_3;
        let w_42 = platform_q2_squared + platform_q3_squared;
        let w_51 = platform_q1_squared + platform_q3_squared;
        let pivot_platform_q1 = mass_platform_q1_platform_q1
            - mass_platform_q1_platform_q0 * l_platform_q1_platform_q0;
        let inverse_platform_q1 = S::from_f64(1.0) / pivot_platform_q1;
        let w_37 = platform_q1 * platform_q3;
        let k_platform_q3_platform_q1 = w_31 * w_37 + platform_q0 * w_32 * self.k_5
            - mass_platform_q1_platform_q0 * l_platform_q3_platform_q0;
        let l_platform_q3_platform_q1 = inverse_platform_q1 * k_platform_q3_platform_q1;
        let w_38 = platform_q1 * w_squared;
        let w_39 = platform_q0 * platform_q2;
        let w_54 = w_37 - w_39;
        let mass_platform_q2_platform_q0 = platform_q3 * self.k_5 * w_38 + w_31 * w_39;
        let l_platform_q2_platform_q0 = mass_platform_q2_platform_q0
            * inverse_platform_q0;
        let k_platform_q2_platform_q1 = platform_q1 * platform_q2 * w_34
            - mass_platform_q1_platform_q0 * l_platform_q2_platform_q0;
        let l_platform_q2_platform_q1 = inverse_platform_q1 * k_platform_q2_platform_q1;
        let pivot_platform_q2 = mass_platform_q2_platform_q2
            - mass_platform_q2_platform_q0 * l_platform_q2_platform_q0
            - k_platform_q2_platform_q1 * l_platform_q2_platform_q1;
        let inverse_platform_q2 = S::from_f64(1.0) / pivot_platform_q2;
        let w_40 = platform_q2 * platform_q3;
        let k_platform_q3_platform_q2 = platform_q0 * self.k_4 * w_38 + w_31 * w_40
            - mass_platform_q2_platform_q0 * l_platform_q3_platform_q0
            - k_platform_q2_platform_q1 * l_platform_q3_platform_q1;
        let w_55 = w_40 + platform_q1 * platform_q0;
        let l_platform_q3_platform_q2 = inverse_platform_q2 * k_platform_q3_platform_q2;
        let w_41 = platform_q1 * w_25;
        let minus_rhs_platform_q2 = S::from_f64(8.0) * w
            * (platform_q3 * w_22 + platform_q0 * w_23) + w_27 * w_41
            + platform_q2 * w_29 + rhs_platform_q0 * l_platform_q2_platform_q0
            + l_platform_q2_platform_q1 * rhs_platform_q1;
        let rhs_platform_q3 = S::from_f64(8.0) * w
            * (platform_q2 * w_22 - platform_q1 * w_23) + platform_q0 * w_25 * w_27
            - platform_q3 * w_29 - rhs_platform_q0 * l_platform_q3_platform_q0
            - l_platform_q3_platform_q1 * rhs_platform_q1
            + l_platform_q3_platform_q2 * minus_rhs_platform_q2;
        let w_129 = S::from_f64(4.0) * w_25;
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
        let w_43 = w * S::from_f64(2.0);
        let w_44 = w_42 * w_43 - S::from_f64(1.0);
        let w_52 = w_43 * w_51 - S::from_f64(1.0);
        let w_45 = platform_q1 * platform_q2;
        let w_46 = w_45 - w_35;
        let w_49 = w_45 + w_35;
        let w_47 = w * w_46;
        let w_48 = platform_x - self.k_6 - w_44 * self.k_7 + self.k_8 * w_47;
        let w_50 = w * w_49;
        let w_53 = platform_y - self.k_9 + self.k_10 * w_50 - w_52 * self.k_11;
        let w_56 = self.k_10 * w_54 + self.k_8 * w_55;
        let a1_on_platform_z = platform_z + w * w_56;
        let w_57 = w_48 * w_48 + w_53 * w_53 + a1_on_platform_z * a1_on_platform_z;
        let sqrt_w_57 = w_57.sqrt();
        let w_58 = S::from_f64(2.0) * sqrt_w_57;
        let w_59 = platform_q1 * w;
        let w_60 = w - w_squared * w_42;
        let w_61 = platform_q2 * w_60;
        let w_62 = w_32 * w_46;
        let w_63 = self.k_11 * w_59 - self.k_10 * w_61 - self.k_8 * w_62;
        let w_64 = self.k_8 * w_51 - w_49 * self.k_10;
        let w_65 = self.k_7 * w_59 + w_32 * w_64;
        let w_66 = w * (platform_q3 * self.k_11 - platform_q0 * self.k_7) - w_32 * w_56;
        let w_67 = w_48 * w_63 + w_53 * w_65 + a1_on_platform_z * w_66;
        let w_68 = w_42 * self.k_10 - w_46 * self.k_8;
        let w_69 = platform_q3 * w;
        let w_70 = platform_q0 * w_squared * w_68 - self.k_11 * w_69;
        let w_71 = platform_q0 * w_squared * w_64 + self.k_7 * w_69;
        let w_72 = platform_q0 * w_squared;
        let w_73 = w * (platform_q2 * self.k_7 - platform_q1 * self.k_11) + w_56 * w_72;
        let w_74 = w_48 * w_70 + w_53 * w_71 - a1_on_platform_z * w_73;
        let a1_leg_by_platform_q0 = w_74 * w_58 / w_57;
        let l_lambda_a1_leg_platform_q0 = a1_leg_by_platform_q0 * inverse_platform_q0;
        let w_75 = platform_q2 * w;
        let w_76 = w_38 * w_68 + self.k_11 * w_75;
        let w_77 = w_38 * w_49;
        let w_78 = w - w_squared * w_51;
        let w_79 = platform_q1 * w_78;
        let w_80 = self.k_7 * w_75 - self.k_10 * w_77 - self.k_8 * w_79;
        let w_81 = w * (platform_q3 * self.k_7 + platform_q0 * self.k_11) - w_38 * w_56;
        let w_82 = w_48 * w_76 + w_53 * w_80 + a1_on_platform_z * w_81;
        let k_lambda_a1_leg_platform_q1 = w_58 * w_82 / w_57
            - mass_platform_q1_platform_q0 * l_lambda_a1_leg_platform_q0;
        let l_lambda_a1_leg_platform_q1 = inverse_platform_q1
            * k_lambda_a1_leg_platform_q1;
        let k_lambda_a1_leg_platform_q2 = w_58 * w_67 / w_57
            - mass_platform_q2_platform_q0 * l_lambda_a1_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_a1_leg_platform_q1;
        let l_lambda_a1_leg_platform_q2 = inverse_platform_q2
            * k_lambda_a1_leg_platform_q2;
        let w_83 = w_squared * w_20;
        let w_85 = w_42 * w_83 - w * w_84;
        let w_86 = w_46 * w_83;
        let w_87 = w_7 + w_8 - w_9 - w_10;
        let w_90 = w_7 + w_8 + w_9 + w_10;
        let w_88 = w * w_87;
        let w_89 = platform_x_dot + w_85 * self.k_48 - self.k_49 * w_86
            - self.k_8 * w_88;
        let w_91 = w * w_90;
        let w_92 = w_49 * w_83;
        let w_94 = w_51 * w_83 - w * w_93;
        let w_95 = platform_y_dot + self.k_10 * w_91 - self.k_48 * w_92
            + self.k_49 * w_94;
        let w_98 = self.k_8 * w_96 - self.k_10 * w_97;
        let w_99 = platform_z_dot
            - w_squared * w_20 * (w_54 * self.k_48 + w_55 * self.k_49) + w * w_98;
        let w_100 = w_48 * w_89 + w_53 * w_95 + a1_on_platform_z * w_99;
        let w_101 = platform_q0 * w;
        let w_102 = platform_q3 * w_60;
        let w_103 = platform_q3 * w_squared;
        let w_104 = w_46 * w_103;
        let w_105 = self.k_11 * w_101 + self.k_10 * w_102 + self.k_8 * w_104;
        let w_106 = w_49 * w_103;
        let w_107 = platform_q3 * w_78;
        let w_108 = self.k_7 * w_101 - self.k_10 * w_106 - self.k_8 * w_107;
        let w_109 = w * (platform_q2 * self.k_11 + platform_q1 * self.k_7)
            - w_56 * w_103;
        let w_110 = w_48 * w_105 - w_53 * w_108 - a1_on_platform_z * w_109;
        let minus_k_lambda_a1_leg_platform_q3 = w_58 * w_110 / w_57
            + mass_platform_q3_platform_q0 * l_lambda_a1_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_a1_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_a1_leg_platform_q2;
        let w_57_squared = w_57 * w_57;
        let w_111 = w_100
            * ((w_110 * platform_q3_dot - w_74 * platform_q0_dot - w_82 * platform_q1_dot
                - w_67 * platform_q2_dot) / w_57_squared);
        let w_112 = w_84 * self.k_48 + self.k_8 * w_87;
        let w_113 = platform_q3 * w_20;
        let w_114 = w_46 * self.k_51 - w_42 * self.k_50;
        let w_115 = w * platform_q3_dot;
        let w_116 = w_48
            * (w_squared
                * (platform_q0 * w_112 + w_68 * platform_q0_dot + self.k_8 * w_113)
                + platform_q0 * w_20 * w_24 * w_114 - self.k_11 * w_115);
        let w_117 = w_113 + platform_q0 * w_90;
        let w_118 = platform_q0 * w_93;
        let w_119 = w_49 * self.k_50 - w_51 * self.k_51;
        let w_120 = w_53
            * (w_squared
                * (w_64 * platform_q0_dot - self.k_10 * w_117 + self.k_49 * w_118)
                + platform_q0 * w_20 * w_24 * w_119 + self.k_7 * w_115);
        let w_121 = w_squared
            * (w_20 * (platform_q1 * self.k_8 - platform_q2 * self.k_10)
                + w_56 * platform_q0_dot + platform_q0 * w_98);
        let w_122 = w_54 * self.k_50 + w_55 * self.k_51;
        let w_123 = w_70 * w_89 + w_116 + w_71 * w_95 + w_120 - w_73 * w_99
            - a1_on_platform_z
                * (w_121 - platform_q0 * w_20 * w_24 * w_122
                    + w * (self.k_7 * platform_q2_dot - self.k_11 * platform_q1_dot));
        let w_124 = platform_q2 * w_20;
        let w_125 = w * platform_q2_dot;
        let w_126 = w_48
            * (w_squared
                * (w_68 * platform_q1_dot + platform_q1 * w_112 - self.k_8 * w_124)
                + w_41 * w_114 + self.k_11 * w_125);
        let w_127 = w_squared * (w_124 + w_49 * platform_q1_dot + platform_q1 * w_90);
        let w_128 = w_49 * w_41;
        let w_130 = w_51 * w_129;
        let w_138 = w_42 * w_129;
        let w_131 = w_20 + w_93;
        let w_143 = platform_q2 * w_93;
        let w_132 = platform_q1 * (w_130 - S::from_f64(2.0) * w_squared * w_131)
            + w_78 * platform_q1_dot;
        let w_133 = w * (self.k_7 * platform_q3_dot + self.k_11 * platform_q0_dot)
            - w_squared
                * (w_20 * (platform_q3 * self.k_10 + platform_q0 * self.k_8)
                    + w_56 * platform_q1_dot + platform_q1 * w_98) + w_41 * w_122;
        let w_134 = w_76 * w_89 + w_126 + w_80 * w_95
            + w_53
                * (self.k_7 * w_125 - self.k_10 * w_127 + self.k_50 * w_128
                    - self.k_8 * w_132) + w_81 * w_99 + a1_on_platform_z * w_133;
        let w_135 = platform_q1 * w_20;
        let w_136 = w_squared * (platform_q2 * w_87 - w_135 - w_46 * platform_q2_dot);
        let w_142 = w_135 + platform_q2 * w_90;
        let w_137 = w * platform_q1_dot;
        let w_144 = w_53
            * (w_squared
                * (w_64 * platform_q2_dot - self.k_10 * w_142 + self.k_49 * w_143)
                + self.k_7 * w_137 + w_30 * w_119);
        let w_139 = w_20 + w_84;
        let w_140 = platform_q2 * (w_138 - S::from_f64(2.0) * w_squared * w_139)
            + w_60 * platform_q2_dot;
        let w_141 = w_46 * w_30;
        let w_145 = w_squared
            * (w_20 * (platform_q0 * self.k_10 - platform_q3 * self.k_8)
                - w_56 * platform_q2_dot - platform_q2 * w_98)
            + w * (self.k_11 * platform_q3_dot - self.k_7 * platform_q0_dot)
            + w_30 * w_122;
        let w_146 = w_63 * w_89
            + w_48
                * (self.k_8 * w_136 + self.k_11 * w_137 - self.k_10 * w_140
                    + self.k_51 * w_141) + w_65 * w_95 + w_144 + w_66 * w_99
            + a1_on_platform_z * w_145;
        let w_157 = w * (self.k_11 * platform_q2_dot + self.k_7 * platform_q1_dot)
            - w_squared
                * (w_20 * (platform_q2 * self.k_8 + platform_q1 * self.k_10)
                    + w_56 * platform_q3_dot + platform_q3 * w_98) + w_26 * w_122;
        let w_147 = platform_q0 * w_20;
        let w_153 = w_squared * (w_147 + w_49 * platform_q3_dot + platform_q3 * w_90);
        let w_148 = w_squared * (w_46 * platform_q3_dot - w_147 - platform_q3 * w_87);
        let w_149 = w * platform_q0_dot;
        let w_150 = w_squared * S::from_f64(2.0);
        let w_151 = platform_q3 * (w_138 - w_139 * w_150) + w_60 * platform_q3_dot;
        let w_155 = platform_q3 * (w_130 - w_131 * w_150) + w_78 * platform_q3_dot;
        let w_152 = w_46 * w_26;
        let w_154 = w_49 * w_26;
        let w_156 = w_53
            * (self.k_7 * w_149 - self.k_10 * w_153 + self.k_50 * w_154
                - self.k_8 * w_155);
        let w_158 = w_105 * w_89
            + w_48
                * (self.k_8 * w_148 + self.k_11 * w_149 + self.k_10 * w_151
                    - self.k_51 * w_152) - w_108 * w_95 - w_156 - w_109 * w_99
            - a1_on_platform_z * w_157;
        let w_159 = S::from_f64(2.0)
            * (w_111
                + (platform_q0_dot * w_123 + platform_q1_dot * w_134
                    + platform_q2_dot * w_146 - platform_q3_dot * w_158) / w_57);
        let w_160 = w_159
            + (platform_x_dot * w_89 + platform_y_dot * w_95 + platform_z_dot * w_99)
                / w_57
            - w_100
                * ((w_48 * platform_x_dot + w_53 * platform_y_dot
                    + a1_on_platform_z * platform_z_dot) / w_57_squared);
        let a1_leg_by_platform_z = a1_on_platform_z * sqrt_w_57 / w_57;
        let a1_leg_by_platform_x = w_48 * sqrt_w_57 / w_57;
        let a1_leg_by_platform_y = w_53 * sqrt_w_57 / w_57;
        let w_161 = self.w * t;
        let w_162 = self.k_12 + w_161;
        let w_163 = self.k_25 + w_161;
        let w_164 = self.k_38 + w_161;
        let (
            [sin_w_161,
            sin_w_162,
            sin_w_163,
            sin_w_164,
            ],
            [cos_w_161,
            cos_w_162,
            cos_w_163,
            cos_w_164,
            ],
        ) = S::sin_cos_each([w_161, w_162, w_163, w_164]);
        let minus_l_lambda_a1_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_a1_leg_platform_q3;
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
            - (sqrt_w_57 * w_160 + sin_w_161 * self.k_54)
            - rhs_platform_q0 * l_lambda_a1_leg_platform_q0
            - l_lambda_a1_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_a1_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_a1_leg_platform_z
            + minus_l_lambda_a1_leg_lambda_platform_norm * rhs_lambda_platform_norm;
        let w_165 = platform_x - self.k_13 - w_44 * self.k_14 + w_47 * self.k_15;
        let w_166 = platform_y - self.k_16 + w_50 * self.k_17 - w_52 * self.k_18;
        let w_167 = w_54 * self.k_17 + w_55 * self.k_15;
        let a2_on_platform_z = platform_z + w * w_167;
        let w_168 = w_165 * w_165 + w_166 * w_166 + a2_on_platform_z * a2_on_platform_z;
        let sqrt_w_168 = w_168.sqrt();
        let w_169 = S::from_f64(2.0) * sqrt_w_168;
        let w_170 = w_59 * self.k_18 - w_61 * self.k_17 - w_62 * self.k_15;
        let w_171 = w_51 * self.k_15 - w_49 * self.k_17;
        let w_172 = w_59 * self.k_14 + w_32 * w_171;
        let w_173 = w * (platform_q3 * self.k_18 - platform_q0 * self.k_14)
            - w_32 * w_167;
        let w_174 = w_165 * w_170 + w_166 * w_172 + a2_on_platform_z * w_173;
        let w_175 = w_42 * self.k_17 - w_46 * self.k_15;
        let w_176 = platform_q0 * w_squared * w_175 - w_69 * self.k_18;
        let w_177 = platform_q0 * w_squared * w_171 + w_69 * self.k_14;
        let w_178 = w * (platform_q2 * self.k_14 - platform_q1 * self.k_18)
            + w_72 * w_167;
        let w_179 = w_165 * w_176 + w_166 * w_177 - a2_on_platform_z * w_178;
        let a2_leg_by_platform_q0 = w_179 * w_169 / w_168;
        let l_lambda_a2_leg_platform_q0 = a2_leg_by_platform_q0 * inverse_platform_q0;
        let w_180 = w_38 * w_175 + w_75 * self.k_18;
        let w_181 = w_75 * self.k_14 - w_77 * self.k_17 - w_79 * self.k_15;
        let w_182 = w * (platform_q3 * self.k_14 + platform_q0 * self.k_18)
            - w_38 * w_167;
        let w_183 = w_165 * w_180 + w_166 * w_181 + a2_on_platform_z * w_182;
        let k_lambda_a2_leg_platform_q1 = w_169 * w_183 / w_168
            - mass_platform_q1_platform_q0 * l_lambda_a2_leg_platform_q0;
        let l_lambda_a2_leg_platform_q1 = inverse_platform_q1
            * k_lambda_a2_leg_platform_q1;
        let k_lambda_a2_leg_platform_q2 = w_169 * w_174 / w_168
            - mass_platform_q2_platform_q0 * l_lambda_a2_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_a2_leg_platform_q1;
        let l_lambda_a2_leg_platform_q2 = inverse_platform_q2
            * k_lambda_a2_leg_platform_q2;
        let w_184 = platform_x_dot + w_85 * self.k_55 - w_86 * self.k_56
            - self.k_15 * w_88;
        let w_185 = platform_y_dot + self.k_17 * w_91 - w_92 * self.k_55
            + w_94 * self.k_56;
        let w_186 = self.k_15 * w_96 - self.k_17 * w_97;
        let w_187 = platform_z_dot
            - w_squared * w_20 * (w_54 * self.k_55 + w_55 * self.k_56) + w * w_186;
        let w_188 = w_165 * w_184 + w_166 * w_185 + a2_on_platform_z * w_187;
        let w_189 = w_101 * self.k_18 + w_102 * self.k_17 + w_104 * self.k_15;
        let w_190 = w_101 * self.k_14 - w_106 * self.k_17 - w_107 * self.k_15;
        let w_191 = w * (platform_q2 * self.k_18 + platform_q1 * self.k_14)
            - w_103 * w_167;
        let w_192 = w_165 * w_189 - w_166 * w_190 - a2_on_platform_z * w_191;
        let minus_k_lambda_a2_leg_platform_q3 = w_169 * w_192 / w_168
            + mass_platform_q3_platform_q0 * l_lambda_a2_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_a2_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_a2_leg_platform_q2;
        let w_168_squared = w_168 * w_168;
        let w_193 = w_188
            * ((w_192 * platform_q3_dot - w_179 * platform_q0_dot
                - w_183 * platform_q1_dot - w_174 * platform_q2_dot) / w_168_squared);
        let w_194 = w_84 * self.k_55 + self.k_15 * w_87;
        let w_195 = w_46 * self.k_58 - w_42 * self.k_57;
        let w_196 = w_165
            * (w_squared
                * (platform_q0 * w_194 + w_175 * platform_q0_dot + self.k_15 * w_113)
                + platform_q0 * w_20 * w_24 * w_195 - self.k_18 * w_115);
        let w_202 = w_165
            * (w_squared
                * (w_175 * platform_q1_dot + platform_q1 * w_194 - self.k_15 * w_124)
                + w_41 * w_195 + self.k_18 * w_125);
        let w_197 = w_49 * self.k_57 - w_51 * self.k_58;
        let w_198 = w_166
            * (w_squared
                * (w_171 * platform_q0_dot - self.k_17 * w_117 + w_118 * self.k_56)
                + platform_q0 * w_20 * w_24 * w_197 + self.k_14 * w_115);
        let w_205 = w_166
            * (w_squared
                * (w_171 * platform_q2_dot - self.k_17 * w_142 + w_143 * self.k_56)
                + self.k_14 * w_137 + w_30 * w_197);
        let w_199 = w_squared
            * (w_20 * (platform_q1 * self.k_15 - platform_q2 * self.k_17)
                + w_167 * platform_q0_dot + platform_q0 * w_186);
        let w_200 = w_54 * self.k_57 + w_55 * self.k_58;
        let w_201 = w_176 * w_184 + w_196 + w_177 * w_185 + w_198 - w_178 * w_187
            - a2_on_platform_z
                * (w_199 - platform_q0 * w_20 * w_24 * w_200
                    + w * (self.k_14 * platform_q2_dot - self.k_18 * platform_q1_dot));
        let w_203 = w * (self.k_14 * platform_q3_dot + self.k_18 * platform_q0_dot)
            - w_squared
                * (w_20 * (platform_q3 * self.k_17 + platform_q0 * self.k_15)
                    + w_167 * platform_q1_dot + platform_q1 * w_186) + w_41 * w_200;
        let w_204 = w_180 * w_184 + w_202 + w_181 * w_185
            + w_166
                * (self.k_14 * w_125 - self.k_17 * w_127 + w_128 * self.k_57
                    - self.k_15 * w_132) + w_182 * w_187 + a2_on_platform_z * w_203;
        let w_206 = w_squared
            * (w_20 * (platform_q0 * self.k_17 - platform_q3 * self.k_15)
                - w_167 * platform_q2_dot - platform_q2 * w_186)
            + w * (self.k_18 * platform_q3_dot - self.k_14 * platform_q0_dot)
            + w_30 * w_200;
        let w_207 = w_170 * w_184
            + w_165
                * (self.k_15 * w_136 + self.k_18 * w_137 - self.k_17 * w_140
                    + w_141 * self.k_58) + w_172 * w_185 + w_205 + w_173 * w_187
            + a2_on_platform_z * w_206;
        let w_209 = w * (self.k_18 * platform_q2_dot + self.k_14 * platform_q1_dot)
            - w_squared
                * (w_20 * (platform_q2 * self.k_15 + platform_q1 * self.k_17)
                    + w_167 * platform_q3_dot + platform_q3 * w_186) + w_26 * w_200;
        let w_208 = w_166
            * (self.k_14 * w_149 - self.k_17 * w_153 + w_154 * self.k_57
                - self.k_15 * w_155);
        let w_210 = w_189 * w_184
            + w_165
                * (self.k_15 * w_148 + self.k_18 * w_149 + self.k_17 * w_151
                    - w_152 * self.k_58) - w_190 * w_185 - w_208 - w_191 * w_187
            - a2_on_platform_z * w_209;
        let w_211 = S::from_f64(2.0)
            * (w_193
                + (platform_q0_dot * w_201 + platform_q1_dot * w_204
                    + platform_q2_dot * w_207 - platform_q3_dot * w_210) / w_168);
        let w_212 = w_211
            + (platform_x_dot * w_184 + platform_y_dot * w_185 + platform_z_dot * w_187)
                / w_168
            - w_188
                * ((w_165 * platform_x_dot + w_166 * platform_y_dot
                    + a2_on_platform_z * platform_z_dot) / w_168_squared);
        let a2_leg_by_platform_z = a2_on_platform_z * sqrt_w_168 / w_168;
        let a2_leg_by_platform_x = w_165 * sqrt_w_168 / w_168;
        let a2_leg_by_platform_y = w_166 * sqrt_w_168 / w_168;
        let w_213 = sin_w_161 * self.k_52;
        let w_214 = self.k_53 * sin_w_162;
        let minus_l_lambda_a2_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_a2_leg_platform_q3;
        let l_lambda_a2_leg_platform_z = a2_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_a2_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_a2_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_a2_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_a2_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_a2_leg_platform_q2;
        let minus_l_lambda_a2_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_a2_leg_lambda_platform_norm;
        let l_lambda_a1_leg_platform_x = a1_leg_by_platform_x * self.inverse_platform_x;
        let l_lambda_a1_leg_platform_y = a1_leg_by_platform_y * self.inverse_platform_x;
        let w_215 = a1_leg_by_platform_q0 * l_lambda_a1_leg_platform_q0
            + k_lambda_a1_leg_platform_q1 * l_lambda_a1_leg_platform_q1
            + k_lambda_a1_leg_platform_q2 * l_lambda_a1_leg_platform_q2
            + minus_k_lambda_a1_leg_platform_q3 * minus_l_lambda_a1_leg_platform_q3
            + a1_leg_by_platform_x * l_lambda_a1_leg_platform_x
            + a1_leg_by_platform_y * l_lambda_a1_leg_platform_y
            + a1_leg_by_platform_z * l_lambda_a1_leg_platform_z;
        let pivot_lambda_a1_leg = k_lambda_a1_leg_lambda_platform_norm
            * minus_l_lambda_a1_leg_lambda_platform_norm - w_215;
        let inverse_lambda_a1_leg = S::from_f64(1.0) / pivot_lambda_a1_leg;
        let l_lambda_a2_leg_platform_x = a2_leg_by_platform_x * self.inverse_platform_x;
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
            - (sqrt_w_168 * w_212 + w_213 - w_214)
            - rhs_platform_q0 * l_lambda_a2_leg_platform_q0
            - l_lambda_a2_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_a2_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_a2_leg_platform_z
            + minus_l_lambda_a2_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_a2_leg_lambda_a1_leg * rhs_lambda_a1_leg;
        let w_216 = platform_x - self.k_19 - w_44 * self.k_20 + w_47 * self.k_21;
        let w_217 = platform_y - self.k_22 + w_50 * self.k_23 - w_52 * self.k_24;
        let w_218 = w_54 * self.k_23 + w_55 * self.k_21;
        let b1_on_platform_z = platform_z + w * w_218;
        let w_219 = w_216 * w_216 + w_217 * w_217 + b1_on_platform_z * b1_on_platform_z;
        let sqrt_w_219 = w_219.sqrt();
        let w_220 = S::from_f64(2.0) * sqrt_w_219;
        let w_221 = w_59 * self.k_24 - w_61 * self.k_23 - w_62 * self.k_21;
        let w_222 = w_51 * self.k_21 - w_49 * self.k_23;
        let w_223 = w_59 * self.k_20 + w_32 * w_222;
        let w_224 = w * (platform_q3 * self.k_24 - platform_q0 * self.k_20)
            - w_32 * w_218;
        let w_225 = w_216 * w_221 + w_217 * w_223 + b1_on_platform_z * w_224;
        let w_226 = w_42 * self.k_23 - w_46 * self.k_21;
        let w_227 = platform_q0 * w_squared * w_226 - w_69 * self.k_24;
        let w_228 = platform_q0 * w_squared * w_222 + w_69 * self.k_20;
        let w_229 = w * (platform_q2 * self.k_20 - platform_q1 * self.k_24)
            + w_72 * w_218;
        let w_230 = w_216 * w_227 + w_217 * w_228 - b1_on_platform_z * w_229;
        let b1_leg_by_platform_q0 = w_230 * w_220 / w_219;
        let l_lambda_b1_leg_platform_q0 = b1_leg_by_platform_q0 * inverse_platform_q0;
        let w_231 = w_38 * w_226 + w_75 * self.k_24;
        let w_232 = w_75 * self.k_20 - w_77 * self.k_23 - w_79 * self.k_21;
        let w_233 = w * (platform_q3 * self.k_20 + platform_q0 * self.k_24)
            - w_38 * w_218;
        let w_234 = w_216 * w_231 + w_217 * w_232 + b1_on_platform_z * w_233;
        let k_lambda_b1_leg_platform_q1 = w_220 * w_234 / w_219
            - mass_platform_q1_platform_q0 * l_lambda_b1_leg_platform_q0;
        let l_lambda_b1_leg_platform_q1 = inverse_platform_q1
            * k_lambda_b1_leg_platform_q1;
        let k_lambda_b1_leg_platform_q2 = w_220 * w_225 / w_219
            - mass_platform_q2_platform_q0 * l_lambda_b1_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_b1_leg_platform_q1;
        let l_lambda_b1_leg_platform_q2 = inverse_platform_q2
            * k_lambda_b1_leg_platform_q2;
        let w_235 = platform_x_dot + w_85 * self.k_59 - w_86 * self.k_60
            - self.k_21 * w_88;
        let w_236 = platform_y_dot + self.k_23 * w_91 - w_92 * self.k_59
            + w_94 * self.k_60;
        let w_237 = self.k_21 * w_96 - self.k_23 * w_97;
        let w_238 = platform_z_dot
            - w_squared * w_20 * (w_54 * self.k_59 + w_55 * self.k_60) + w * w_237;
        let w_239 = w_216 * w_235 + w_217 * w_236 + b1_on_platform_z * w_238;
        let w_240 = w_101 * self.k_24 + w_102 * self.k_23 + w_104 * self.k_21;
        let w_241 = w_101 * self.k_20 - w_106 * self.k_23 - w_107 * self.k_21;
        let w_242 = w * (platform_q2 * self.k_24 + platform_q1 * self.k_20)
            - w_103 * w_218;
        let w_243 = w_216 * w_240 - w_217 * w_241 - b1_on_platform_z * w_242;
        let minus_k_lambda_b1_leg_platform_q3 = w_220 * w_243 / w_219
            + mass_platform_q3_platform_q0 * l_lambda_b1_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_b1_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_b1_leg_platform_q2;
        let w_219_squared = w_219 * w_219;
        let w_244 = w_239
            * ((w_243 * platform_q3_dot - w_230 * platform_q0_dot
                - w_234 * platform_q1_dot - w_225 * platform_q2_dot) / w_219_squared);
        let w_245 = w_84 * self.k_59 + self.k_21 * w_87;
        let w_246 = w_46 * self.k_62 - w_42 * self.k_61;
        let w_247 = w_216
            * (w_squared
                * (platform_q0 * w_245 + w_226 * platform_q0_dot + self.k_21 * w_113)
                + platform_q0 * w_20 * w_24 * w_246 - self.k_24 * w_115);
        let w_253 = w_216
            * (w_squared
                * (w_226 * platform_q1_dot + platform_q1 * w_245 - self.k_21 * w_124)
                + w_41 * w_246 + self.k_24 * w_125);
        let w_248 = w_49 * self.k_61 - w_51 * self.k_62;
        let w_249 = w_217
            * (w_squared
                * (w_222 * platform_q0_dot - self.k_23 * w_117 + w_118 * self.k_60)
                + platform_q0 * w_20 * w_24 * w_248 + self.k_20 * w_115);
        let w_256 = w_217
            * (w_squared
                * (w_222 * platform_q2_dot - self.k_23 * w_142 + w_143 * self.k_60)
                + self.k_20 * w_137 + w_30 * w_248);
        let w_250 = w_squared
            * (w_20 * (platform_q1 * self.k_21 - platform_q2 * self.k_23)
                + w_218 * platform_q0_dot + platform_q0 * w_237);
        let w_251 = w_54 * self.k_61 + w_55 * self.k_62;
        let w_252 = w_227 * w_235 + w_247 + w_228 * w_236 + w_249 - w_229 * w_238
            - b1_on_platform_z
                * (w_250 - platform_q0 * w_20 * w_24 * w_251
                    + w * (self.k_20 * platform_q2_dot - self.k_24 * platform_q1_dot));
        let w_254 = w * (self.k_20 * platform_q3_dot + self.k_24 * platform_q0_dot)
            - w_squared
                * (w_20 * (platform_q3 * self.k_23 + platform_q0 * self.k_21)
                    + w_218 * platform_q1_dot + platform_q1 * w_237) + w_41 * w_251;
        let w_255 = w_231 * w_235 + w_253 + w_232 * w_236
            + w_217
                * (self.k_20 * w_125 - self.k_23 * w_127 + w_128 * self.k_61
                    - self.k_21 * w_132) + w_233 * w_238 + b1_on_platform_z * w_254;
        let w_257 = w_squared
            * (w_20 * (platform_q0 * self.k_23 - platform_q3 * self.k_21)
                - w_218 * platform_q2_dot - platform_q2 * w_237)
            + w * (self.k_24 * platform_q3_dot - self.k_20 * platform_q0_dot)
            + w_30 * w_251;
        let w_258 = w_221 * w_235
            + w_216
                * (self.k_21 * w_136 + self.k_24 * w_137 - self.k_23 * w_140
                    + w_141 * self.k_62) + w_223 * w_236 + w_256 + w_224 * w_238
            + b1_on_platform_z * w_257;
        let w_260 = w * (self.k_24 * platform_q2_dot + self.k_20 * platform_q1_dot)
            - w_squared
                * (w_20 * (platform_q2 * self.k_21 + platform_q1 * self.k_23)
                    + w_218 * platform_q3_dot + platform_q3 * w_237) + w_26 * w_251;
        let w_259 = w_217
            * (self.k_20 * w_149 - self.k_23 * w_153 + w_154 * self.k_61
                - self.k_21 * w_155);
        let w_261 = w_240 * w_235
            + w_216
                * (self.k_21 * w_148 + self.k_24 * w_149 + self.k_23 * w_151
                    - w_152 * self.k_62) - w_241 * w_236 - w_259 - w_242 * w_238
            - b1_on_platform_z * w_260;
        let w_262 = S::from_f64(2.0)
            * (w_244
                + (platform_q0_dot * w_252 + platform_q1_dot * w_255
                    + platform_q2_dot * w_258 - platform_q3_dot * w_261) / w_219);
        let w_263 = w_262
            + (platform_x_dot * w_235 + platform_y_dot * w_236 + platform_z_dot * w_238)
                / w_219
            - w_239
                * ((w_216 * platform_x_dot + w_217 * platform_y_dot
                    + b1_on_platform_z * platform_z_dot) / w_219_squared);
        let b1_leg_by_platform_z = b1_on_platform_z * sqrt_w_219 / w_219;
        let b1_leg_by_platform_x = w_216 * sqrt_w_219 / w_219;
        let b1_leg_by_platform_y = w_217 * sqrt_w_219 / w_219;
        let minus_l_lambda_b1_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_b1_leg_platform_q3;
        let l_lambda_b1_leg_platform_z = b1_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_b1_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_b1_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_b1_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_b1_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_b1_leg_platform_q2;
        let minus_l_lambda_b1_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_b1_leg_lambda_platform_norm;
        let l_lambda_b1_leg_platform_x = b1_leg_by_platform_x * self.inverse_platform_x;
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
        let w_264 = a2_leg_by_platform_q0 * l_lambda_a2_leg_platform_q0
            + k_lambda_a2_leg_platform_q1 * l_lambda_a2_leg_platform_q1
            + k_lambda_a2_leg_platform_q2 * l_lambda_a2_leg_platform_q2
            + minus_k_lambda_a2_leg_platform_q3 * minus_l_lambda_a2_leg_platform_q3
            + a2_leg_by_platform_x * l_lambda_a2_leg_platform_x
            + a2_leg_by_platform_y * l_lambda_a2_leg_platform_y
            + a2_leg_by_platform_z * l_lambda_a2_leg_platform_z;
        let pivot_lambda_a2_leg = k_lambda_a2_leg_lambda_platform_norm
            * minus_l_lambda_a2_leg_lambda_platform_norm - w_264
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
            - (w_213 + w_214 + sqrt_w_219 * w_263)
            - rhs_platform_q0 * l_lambda_b1_leg_platform_q0
            - l_lambda_b1_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_b1_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_b1_leg_platform_z
            + minus_l_lambda_b1_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_b1_leg_lambda_a1_leg * rhs_lambda_a1_leg
            - l_lambda_b1_leg_lambda_a2_leg * rhs_lambda_a2_leg;
        let w_265 = platform_x - self.k_26 - w_44 * self.k_27 + w_47 * self.k_28;
        let w_266 = platform_y - self.k_29 + w_50 * self.k_30 - w_52 * self.k_31;
        let w_267 = w_54 * self.k_30 + w_55 * self.k_28;
        let b2_on_platform_z = platform_z + w * w_267;
        let w_268 = w_265 * w_265 + w_266 * w_266 + b2_on_platform_z * b2_on_platform_z;
        let sqrt_w_268 = w_268.sqrt();
        let w_269 = S::from_f64(2.0) * sqrt_w_268;
        let w_270 = w_59 * self.k_31 - w_61 * self.k_30 - w_62 * self.k_28;
        let w_271 = w_51 * self.k_28 - w_49 * self.k_30;
        let w_272 = w_59 * self.k_27 + w_32 * w_271;
        let w_273 = w * (platform_q3 * self.k_31 - platform_q0 * self.k_27)
            - w_32 * w_267;
        let w_274 = w_265 * w_270 + w_266 * w_272 + b2_on_platform_z * w_273;
        let w_275 = w_42 * self.k_30 - w_46 * self.k_28;
        let w_276 = platform_q0 * w_squared * w_275 - w_69 * self.k_31;
        let w_277 = platform_q0 * w_squared * w_271 + w_69 * self.k_27;
        let w_278 = w * (platform_q2 * self.k_27 - platform_q1 * self.k_31)
            + w_72 * w_267;
        let w_279 = w_265 * w_276 + w_266 * w_277 - b2_on_platform_z * w_278;
        let b2_leg_by_platform_q0 = w_279 * w_269 / w_268;
        let l_lambda_b2_leg_platform_q0 = b2_leg_by_platform_q0 * inverse_platform_q0;
        let w_280 = w_38 * w_275 + w_75 * self.k_31;
        let w_281 = w_75 * self.k_27 - w_77 * self.k_30 - w_79 * self.k_28;
        let w_282 = w * (platform_q3 * self.k_27 + platform_q0 * self.k_31)
            - w_38 * w_267;
        let w_283 = w_265 * w_280 + w_266 * w_281 + b2_on_platform_z * w_282;
        let k_lambda_b2_leg_platform_q1 = w_269 * w_283 / w_268
            - mass_platform_q1_platform_q0 * l_lambda_b2_leg_platform_q0;
        let l_lambda_b2_leg_platform_q1 = inverse_platform_q1
            * k_lambda_b2_leg_platform_q1;
        let k_lambda_b2_leg_platform_q2 = w_269 * w_274 / w_268
            - mass_platform_q2_platform_q0 * l_lambda_b2_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_b2_leg_platform_q1;
        let l_lambda_b2_leg_platform_q2 = inverse_platform_q2
            * k_lambda_b2_leg_platform_q2;
        let w_284 = platform_x_dot + w_85 * self.k_63 - w_86 * self.k_64
            - self.k_28 * w_88;
        let w_285 = platform_y_dot + self.k_30 * w_91 - w_92 * self.k_63
            + w_94 * self.k_64;
        let w_286 = self.k_28 * w_96 - self.k_30 * w_97;
        let w_287 = platform_z_dot
            - w_squared * w_20 * (w_54 * self.k_63 + w_55 * self.k_64) + w * w_286;
        let w_288 = w_265 * w_284 + w_266 * w_285 + b2_on_platform_z * w_287;
        let w_289 = w_101 * self.k_31 + w_102 * self.k_30 + w_104 * self.k_28;
        let w_290 = w_101 * self.k_27 - w_106 * self.k_30 - w_107 * self.k_28;
        let w_291 = w * (platform_q2 * self.k_31 + platform_q1 * self.k_27)
            - w_103 * w_267;
        let w_292 = w_265 * w_289 - w_266 * w_290 - b2_on_platform_z * w_291;
        let minus_k_lambda_b2_leg_platform_q3 = w_269 * w_292 / w_268
            + mass_platform_q3_platform_q0 * l_lambda_b2_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_b2_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_b2_leg_platform_q2;
        let w_268_squared = w_268 * w_268;
        let w_293 = w_288
            * ((w_292 * platform_q3_dot - w_279 * platform_q0_dot
                - w_283 * platform_q1_dot - w_274 * platform_q2_dot) / w_268_squared);
        let w_294 = w_84 * self.k_63 + self.k_28 * w_87;
        let w_295 = w_46 * self.k_66 - w_42 * self.k_65;
        let w_296 = w_265
            * (w_squared
                * (platform_q0 * w_294 + w_275 * platform_q0_dot + self.k_28 * w_113)
                + platform_q0 * w_20 * w_24 * w_295 - self.k_31 * w_115);
        let w_302 = w_265
            * (w_squared
                * (w_275 * platform_q1_dot + platform_q1 * w_294 - self.k_28 * w_124)
                + w_41 * w_295 + self.k_31 * w_125);
        let w_297 = w_49 * self.k_65 - w_51 * self.k_66;
        let w_298 = w_266
            * (w_squared
                * (w_271 * platform_q0_dot - self.k_30 * w_117 + w_118 * self.k_64)
                + platform_q0 * w_20 * w_24 * w_297 + self.k_27 * w_115);
        let w_305 = w_266
            * (w_squared
                * (w_271 * platform_q2_dot - self.k_30 * w_142 + w_143 * self.k_64)
                + self.k_27 * w_137 + w_30 * w_297);
        let w_299 = w_squared
            * (w_20 * (platform_q1 * self.k_28 - platform_q2 * self.k_30)
                + w_267 * platform_q0_dot + platform_q0 * w_286);
        let w_300 = w_54 * self.k_65 + w_55 * self.k_66;
        let w_301 = w_276 * w_284 + w_296 + w_277 * w_285 + w_298 - w_278 * w_287
            - b2_on_platform_z
                * (w_299 - platform_q0 * w_20 * w_24 * w_300
                    + w * (self.k_27 * platform_q2_dot - self.k_31 * platform_q1_dot));
        let w_303 = w * (self.k_27 * platform_q3_dot + self.k_31 * platform_q0_dot)
            - w_squared
                * (w_20 * (platform_q3 * self.k_30 + platform_q0 * self.k_28)
                    + w_267 * platform_q1_dot + platform_q1 * w_286) + w_41 * w_300;
        let w_304 = w_280 * w_284 + w_302 + w_281 * w_285
            + w_266
                * (self.k_27 * w_125 - self.k_30 * w_127 + w_128 * self.k_65
                    - self.k_28 * w_132) + w_282 * w_287 + b2_on_platform_z * w_303;
        let w_306 = w_squared
            * (w_20 * (platform_q0 * self.k_30 - platform_q3 * self.k_28)
                - w_267 * platform_q2_dot - platform_q2 * w_286)
            + w * (self.k_31 * platform_q3_dot - self.k_27 * platform_q0_dot)
            + w_30 * w_300;
        let w_307 = w_270 * w_284
            + w_265
                * (self.k_28 * w_136 + self.k_31 * w_137 - self.k_30 * w_140
                    + w_141 * self.k_66) + w_272 * w_285 + w_305 + w_273 * w_287
            + b2_on_platform_z * w_306;
        let w_309 = w * (self.k_31 * platform_q2_dot + self.k_27 * platform_q1_dot)
            - w_squared
                * (w_20 * (platform_q2 * self.k_28 + platform_q1 * self.k_30)
                    + w_267 * platform_q3_dot + platform_q3 * w_286) + w_26 * w_300;
        let w_308 = w_266
            * (self.k_27 * w_149 - self.k_30 * w_153 + w_154 * self.k_65
                - self.k_28 * w_155);
        let w_310 = w_289 * w_284
            + w_265
                * (self.k_28 * w_148 + self.k_31 * w_149 + self.k_30 * w_151
                    - w_152 * self.k_66) - w_290 * w_285 - w_308 - w_291 * w_287
            - b2_on_platform_z * w_309;
        let w_311 = S::from_f64(2.0)
            * (w_293
                + (platform_q0_dot * w_301 + platform_q1_dot * w_304
                    + platform_q2_dot * w_307 - platform_q3_dot * w_310) / w_268);
        let w_312 = w_311
            + (platform_x_dot * w_284 + platform_y_dot * w_285 + platform_z_dot * w_287)
                / w_268
            - w_288
                * ((w_265 * platform_x_dot + w_266 * platform_y_dot
                    + b2_on_platform_z * platform_z_dot) / w_268_squared);
        let b2_leg_by_platform_z = b2_on_platform_z * sqrt_w_268 / w_268;
        let b2_leg_by_platform_x = w_265 * sqrt_w_268 / w_268;
        let b2_leg_by_platform_y = w_266 * sqrt_w_268 / w_268;
        let w_313 = self.k_53 * sin_w_163;
        let minus_l_lambda_b2_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_b2_leg_platform_q3;
        let l_lambda_b2_leg_platform_z = b2_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_b2_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_b2_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_b2_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_b2_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_b2_leg_platform_q2;
        let minus_l_lambda_b2_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_b2_leg_lambda_platform_norm;
        let l_lambda_b2_leg_platform_x = b2_leg_by_platform_x * self.inverse_platform_x;
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
        let w_314 = b1_leg_by_platform_q0 * l_lambda_b1_leg_platform_q0
            + k_lambda_b1_leg_platform_q1 * l_lambda_b1_leg_platform_q1
            + k_lambda_b1_leg_platform_q2 * l_lambda_b1_leg_platform_q2
            + minus_k_lambda_b1_leg_platform_q3 * minus_l_lambda_b1_leg_platform_q3
            + b1_leg_by_platform_x * l_lambda_b1_leg_platform_x
            + b1_leg_by_platform_y * l_lambda_b1_leg_platform_y
            + b1_leg_by_platform_z * l_lambda_b1_leg_platform_z;
        let pivot_lambda_b1_leg = k_lambda_b1_leg_lambda_platform_norm
            * minus_l_lambda_b1_leg_lambda_platform_norm - w_314
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
            - (w_213 + sqrt_w_268 * w_312 - w_313)
            - rhs_platform_q0 * l_lambda_b2_leg_platform_q0
            - l_lambda_b2_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_b2_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_b2_leg_platform_z
            + minus_l_lambda_b2_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_b2_leg_lambda_a1_leg * rhs_lambda_a1_leg
            - l_lambda_b2_leg_lambda_a2_leg * rhs_lambda_a2_leg
            - l_lambda_b2_leg_lambda_b1_leg * rhs_lambda_b1_leg;
        let w_315 = platform_x - self.k_32 - w_44 * self.k_33 + w_47 * self.k_34;
        let w_364 = platform_x - self.k_39 - w_44 * self.k_40 + w_47 * self.k_41;
        let w_316 = platform_y - self.k_35 + w_50 * self.k_36 - w_52 * self.k_37;
        let w_365 = platform_y - self.k_42 + w_50 * self.k_43 - w_52 * self.k_44;
        let w_317 = w_54 * self.k_36 + w_55 * self.k_34;
        let c1_on_platform_z = platform_z + w * w_317;
        let w_318 = w_315 * w_315 + w_316 * w_316 + c1_on_platform_z * c1_on_platform_z;
        let sqrt_w_318 = w_318.sqrt();
        let w_319 = S::from_f64(2.0) * sqrt_w_318;
        let w_320 = w_59 * self.k_37 - w_61 * self.k_36 - w_62 * self.k_34;
        let w_369 = w_59 * self.k_44 - w_61 * self.k_43 - w_62 * self.k_41;
        let w_321 = w_51 * self.k_34 - w_49 * self.k_36;
        let w_322 = w_59 * self.k_33 + w_32 * w_321;
        let w_323 = w * (platform_q3 * self.k_37 - platform_q0 * self.k_33)
            - w_32 * w_317;
        let w_324 = w_315 * w_320 + w_316 * w_322 + c1_on_platform_z * w_323;
        let w_325 = w_42 * self.k_36 - w_46 * self.k_34;
        let w_326 = platform_q0 * w_squared * w_325 - w_69 * self.k_37;
        let w_327 = platform_q0 * w_squared * w_321 + w_69 * self.k_33;
        let w_328 = w * (platform_q2 * self.k_33 - platform_q1 * self.k_37)
            + w_72 * w_317;
        let w_329 = w_315 * w_326 + w_316 * w_327 - c1_on_platform_z * w_328;
        let c1_leg_by_platform_q0 = w_329 * w_319 / w_318;
        let l_lambda_c1_leg_platform_q0 = c1_leg_by_platform_q0 * inverse_platform_q0;
        let w_330 = w_38 * w_325 + w_75 * self.k_37;
        let w_331 = w_75 * self.k_33 - w_77 * self.k_36 - w_79 * self.k_34;
        let w_380 = w_75 * self.k_40 - w_77 * self.k_43 - w_79 * self.k_41;
        let w_332 = w * (platform_q3 * self.k_33 + platform_q0 * self.k_37)
            - w_38 * w_317;
        let w_333 = w_315 * w_330 + w_316 * w_331 + c1_on_platform_z * w_332;
        let k_lambda_c1_leg_platform_q1 = w_319 * w_333 / w_318
            - mass_platform_q1_platform_q0 * l_lambda_c1_leg_platform_q0;
        let l_lambda_c1_leg_platform_q1 = inverse_platform_q1
            * k_lambda_c1_leg_platform_q1;
        let k_lambda_c1_leg_platform_q2 = w_319 * w_324 / w_318
            - mass_platform_q2_platform_q0 * l_lambda_c1_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_c1_leg_platform_q1;
        let l_lambda_c1_leg_platform_q2 = inverse_platform_q2
            * k_lambda_c1_leg_platform_q2;
        let w_334 = platform_x_dot + w_85 * self.k_67 - w_86 * self.k_68
            - self.k_34 * w_88;
        let w_383 = platform_x_dot + w_85 * self.k_71 - w_86 * self.k_72
            - self.k_41 * w_88;
        let w_335 = platform_y_dot + self.k_36 * w_91 - w_92 * self.k_67
            + w_94 * self.k_68;
        let w_384 = platform_y_dot + self.k_43 * w_91 - w_92 * self.k_71
            + w_94 * self.k_72;
        let w_336 = self.k_34 * w_96 - self.k_36 * w_97;
        let w_385 = self.k_41 * w_96 - self.k_43 * w_97;
        let w_337 = platform_z_dot
            - w_squared * w_20 * (w_54 * self.k_67 + w_55 * self.k_68) + w * w_336;
        let w_338 = w_315 * w_334 + w_316 * w_335 + c1_on_platform_z * w_337;
        let w_339 = w_101 * self.k_37 + w_102 * self.k_36 + w_104 * self.k_34;
        let w_388 = w_101 * self.k_44 + w_102 * self.k_43 + w_104 * self.k_41;
        let w_340 = w_101 * self.k_33 - w_106 * self.k_36 - w_107 * self.k_34;
        let w_389 = w_101 * self.k_40 - w_106 * self.k_43 - w_107 * self.k_41;
        let w_341 = w * (platform_q2 * self.k_37 + platform_q1 * self.k_33)
            - w_103 * w_317;
        let w_342 = w_315 * w_339 - w_316 * w_340 - c1_on_platform_z * w_341;
        let minus_k_lambda_c1_leg_platform_q3 = w_319 * w_342 / w_318
            + mass_platform_q3_platform_q0 * l_lambda_c1_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_c1_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_c1_leg_platform_q2;
        let w_318_squared = w_318 * w_318;
        let w_343 = w_338
            * ((w_342 * platform_q3_dot - w_329 * platform_q0_dot
                - w_333 * platform_q1_dot - w_324 * platform_q2_dot) / w_318_squared);
        let w_344 = w_84 * self.k_67 + self.k_34 * w_87;
        let w_393 = w_84 * self.k_71 + self.k_41 * w_87;
        let w_345 = w_46 * self.k_70 - w_42 * self.k_69;
        let w_346 = w_315
            * (w_squared
                * (platform_q0 * w_344 + w_325 * platform_q0_dot + self.k_34 * w_113)
                + platform_q0 * w_20 * w_24 * w_345 - self.k_37 * w_115);
        let w_352 = w_315
            * (w_squared
                * (w_325 * platform_q1_dot + platform_q1 * w_344 - self.k_34 * w_124)
                + w_41 * w_345 + self.k_37 * w_125);
        let w_347 = w_49 * self.k_69 - w_51 * self.k_70;
        let w_348 = w_316
            * (w_squared
                * (w_321 * platform_q0_dot - self.k_36 * w_117 + w_118 * self.k_68)
                + platform_q0 * w_20 * w_24 * w_347 + self.k_33 * w_115);
        let w_355 = w_316
            * (w_squared
                * (w_321 * platform_q2_dot - self.k_36 * w_142 + w_143 * self.k_68)
                + self.k_33 * w_137 + w_30 * w_347);
        let w_349 = w_squared
            * (w_20 * (platform_q1 * self.k_34 - platform_q2 * self.k_36)
                + w_317 * platform_q0_dot + platform_q0 * w_336);
        let w_350 = w_54 * self.k_69 + w_55 * self.k_70;
        let w_351 = w_326 * w_334 + w_346 + w_327 * w_335 + w_348 - w_328 * w_337
            - c1_on_platform_z
                * (w_349 - platform_q0 * w_20 * w_24 * w_350
                    + w * (self.k_33 * platform_q2_dot - self.k_37 * platform_q1_dot));
        let w_353 = w * (self.k_33 * platform_q3_dot + self.k_37 * platform_q0_dot)
            - w_squared
                * (w_20 * (platform_q3 * self.k_36 + platform_q0 * self.k_34)
                    + w_317 * platform_q1_dot + platform_q1 * w_336) + w_41 * w_350;
        let w_354 = w_330 * w_334 + w_352 + w_331 * w_335
            + w_316
                * (self.k_33 * w_125 - self.k_36 * w_127 + w_128 * self.k_69
                    - self.k_34 * w_132) + w_332 * w_337 + c1_on_platform_z * w_353;
        let w_356 = w_squared
            * (w_20 * (platform_q0 * self.k_36 - platform_q3 * self.k_34)
                - w_317 * platform_q2_dot - platform_q2 * w_336)
            + w * (self.k_37 * platform_q3_dot - self.k_33 * platform_q0_dot)
            + w_30 * w_350;
        let w_357 = w_320 * w_334
            + w_315
                * (self.k_34 * w_136 + self.k_37 * w_137 - self.k_36 * w_140
                    + w_141 * self.k_70) + w_322 * w_335 + w_355 + w_323 * w_337
            + c1_on_platform_z * w_356;
        let w_359 = w * (self.k_37 * platform_q2_dot + self.k_33 * platform_q1_dot)
            - w_squared
                * (w_20 * (platform_q2 * self.k_34 + platform_q1 * self.k_36)
                    + w_317 * platform_q3_dot + platform_q3 * w_336) + w_26 * w_350;
        let w_358 = w_316
            * (self.k_33 * w_149 - self.k_36 * w_153 + w_154 * self.k_69
                - self.k_34 * w_155);
        let w_360 = w_339 * w_334
            + w_315
                * (self.k_34 * w_148 + self.k_37 * w_149 + self.k_36 * w_151
                    - w_152 * self.k_70) - w_340 * w_335 - w_358 - w_341 * w_337
            - c1_on_platform_z * w_359;
        let w_361 = S::from_f64(2.0)
            * (w_343
                + (platform_q0_dot * w_351 + platform_q1_dot * w_354
                    + platform_q2_dot * w_357 - platform_q3_dot * w_360) / w_318);
        let w_362 = w_361
            + (platform_x_dot * w_334 + platform_y_dot * w_335 + platform_z_dot * w_337)
                / w_318
            - w_338
                * ((w_315 * platform_x_dot + w_316 * platform_y_dot
                    + c1_on_platform_z * platform_z_dot) / w_318_squared);
        let c1_leg_by_platform_z = c1_on_platform_z * sqrt_w_318 / w_318;
        let c1_leg_by_platform_x = w_315 * sqrt_w_318 / w_318;
        let c1_leg_by_platform_y = w_316 * sqrt_w_318 / w_318;
        let w_407 = w_365
            * (self.k_40 * w_149 - self.k_43 * w_153 + w_154 * self.k_73
                - self.k_41 * w_155);
        let minus_l_lambda_c1_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_c1_leg_platform_q3;
        let l_lambda_c1_leg_platform_z = c1_leg_by_platform_z * self.inverse_platform_x;
        let k_lambda_c1_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_c1_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_c1_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_c1_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_c1_leg_platform_q2;
        let minus_l_lambda_c1_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_c1_leg_lambda_platform_norm;
        let l_lambda_c1_leg_platform_x = c1_leg_by_platform_x * self.inverse_platform_x;
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
        let w_363 = b2_leg_by_platform_q0 * l_lambda_b2_leg_platform_q0
            + k_lambda_b2_leg_platform_q1 * l_lambda_b2_leg_platform_q1
            + k_lambda_b2_leg_platform_q2 * l_lambda_b2_leg_platform_q2
            + minus_k_lambda_b2_leg_platform_q3 * minus_l_lambda_b2_leg_platform_q3
            + b2_leg_by_platform_x * l_lambda_b2_leg_platform_x
            + b2_leg_by_platform_y * l_lambda_b2_leg_platform_y
            + b2_leg_by_platform_z * l_lambda_b2_leg_platform_z;
        let pivot_lambda_b2_leg = k_lambda_b2_leg_lambda_platform_norm
            * minus_l_lambda_b2_leg_lambda_platform_norm - w_363
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
            - (w_213 + w_313 + sqrt_w_318 * w_362)
            - rhs_platform_q0 * l_lambda_c1_leg_platform_q0
            - l_lambda_c1_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_c1_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_c1_leg_platform_z
            + minus_l_lambda_c1_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_c1_leg_lambda_a1_leg * rhs_lambda_a1_leg
            - l_lambda_c1_leg_lambda_a2_leg * rhs_lambda_a2_leg
            - l_lambda_c1_leg_lambda_b1_leg * rhs_lambda_b1_leg
            - l_lambda_c1_leg_lambda_b2_leg * rhs_lambda_b2_leg;
        let w_366 = w_54 * self.k_43 + w_55 * self.k_41;
        let w_377 = w * (platform_q2 * self.k_40 - platform_q1 * self.k_44)
            + w_72 * w_366;
        let w_390 = w * (platform_q2 * self.k_44 + platform_q1 * self.k_40)
            - w_103 * w_366;
        let c2_on_platform_z = platform_z + w * w_366;
        let w_367 = w_364 * w_364 + w_365 * w_365 + c2_on_platform_z * c2_on_platform_z;
        let sqrt_w_367 = w_367.sqrt();
        let w_368 = S::from_f64(2.0) * sqrt_w_367;
        let w_370 = w_51 * self.k_41 - w_49 * self.k_43;
        let w_371 = w_59 * self.k_40 + w_32 * w_370;
        let w_372 = w * (platform_q3 * self.k_44 - platform_q0 * self.k_40)
            - w_32 * w_366;
        let w_396 = w_49 * self.k_73 - w_51 * self.k_74;
        let w_397 = w_365
            * (w_squared
                * (w_370 * platform_q0_dot - self.k_43 * w_117 + w_118 * self.k_72)
                + platform_q0 * w_20 * w_24 * w_396 + self.k_40 * w_115);
        let w_404 = w_365
            * (w_squared
                * (w_370 * platform_q2_dot - self.k_43 * w_142 + w_143 * self.k_72)
                + self.k_40 * w_137 + w_30 * w_396);
        let w_376 = platform_q0 * w_squared * w_370 + w_69 * self.k_40;
        let w_373 = w_364 * w_369 + w_365 * w_371 + c2_on_platform_z * w_372;
        let w_374 = w_42 * self.k_43 - w_46 * self.k_41;
        let w_375 = platform_q0 * w_squared * w_374 - w_69 * self.k_44;
        let w_379 = w_38 * w_374 + w_75 * self.k_44;
        let w_381 = w * (platform_q3 * self.k_40 + platform_q0 * self.k_44)
            - w_38 * w_366;
        let w_394 = w_46 * self.k_74 - w_42 * self.k_73;
        let w_395 = w_364
            * (w_squared
                * (platform_q0 * w_393 + w_374 * platform_q0_dot + self.k_41 * w_113)
                + platform_q0 * w_20 * w_24 * w_394 - self.k_44 * w_115);
        let w_401 = w_364
            * (w_squared
                * (w_374 * platform_q1_dot + platform_q1 * w_393 - self.k_41 * w_124)
                + w_41 * w_394 + self.k_44 * w_125);
        let w_378 = w_364 * w_375 + w_365 * w_376 - c2_on_platform_z * w_377;
        let c2_leg_by_platform_q0 = w_378 * w_368 / w_367;
        let l_lambda_c2_leg_platform_q0 = c2_leg_by_platform_q0 * inverse_platform_q0;
        let w_382 = w_364 * w_379 + w_365 * w_380 + c2_on_platform_z * w_381;
        let k_lambda_c2_leg_platform_q1 = w_368 * w_382 / w_367
            - mass_platform_q1_platform_q0 * l_lambda_c2_leg_platform_q0;
        let l_lambda_c2_leg_platform_q1 = inverse_platform_q1
            * k_lambda_c2_leg_platform_q1;
        let k_lambda_c2_leg_platform_q2 = w_368 * w_373 / w_367
            - mass_platform_q2_platform_q0 * l_lambda_c2_leg_platform_q0
            - k_platform_q2_platform_q1 * l_lambda_c2_leg_platform_q1;
        let l_lambda_c2_leg_platform_q2 = inverse_platform_q2
            * k_lambda_c2_leg_platform_q2;
        let w_386 = platform_z_dot
            - w_squared * w_20 * (w_54 * self.k_71 + w_55 * self.k_72) + w * w_385;
        let w_399 = w_54 * self.k_73 + w_55 * self.k_74;
        let w_402 = w * (self.k_40 * platform_q3_dot + self.k_44 * platform_q0_dot)
            - w_squared
                * (w_20 * (platform_q3 * self.k_43 + platform_q0 * self.k_41)
                    + w_366 * platform_q1_dot + platform_q1 * w_385) + w_41 * w_399;
        let w_403 = w_379 * w_383 + w_401 + w_380 * w_384
            + w_365
                * (self.k_40 * w_125 - self.k_43 * w_127 + w_128 * self.k_73
                    - self.k_41 * w_132) + w_381 * w_386 + c2_on_platform_z * w_402;
        let w_405 = w_squared
            * (w_20 * (platform_q0 * self.k_43 - platform_q3 * self.k_41)
                - w_366 * platform_q2_dot - platform_q2 * w_385)
            + w * (self.k_44 * platform_q3_dot - self.k_40 * platform_q0_dot)
            + w_30 * w_399;
        let w_406 = w_369 * w_383
            + w_364
                * (self.k_41 * w_136 + self.k_44 * w_137 - self.k_43 * w_140
                    + w_141 * self.k_74) + w_371 * w_384 + w_404 + w_372 * w_386
            + c2_on_platform_z * w_405;
        let w_408 = w * (self.k_44 * platform_q2_dot + self.k_40 * platform_q1_dot)
            - w_squared
                * (w_20 * (platform_q2 * self.k_41 + platform_q1 * self.k_43)
                    + w_366 * platform_q3_dot + platform_q3 * w_385) + w_26 * w_399;
        let w_398 = w_squared
            * (w_20 * (platform_q1 * self.k_41 - platform_q2 * self.k_43)
                + w_366 * platform_q0_dot + platform_q0 * w_385);
        let w_400 = w_375 * w_383 + w_395 + w_376 * w_384 + w_397 - w_377 * w_386
            - c2_on_platform_z
                * (w_398 - platform_q0 * w_20 * w_24 * w_399
                    + w * (self.k_40 * platform_q2_dot - self.k_44 * platform_q1_dot));
        let w_409 = w_388 * w_383
            + w_364
                * (self.k_41 * w_148 + self.k_44 * w_149 + self.k_43 * w_151
                    - w_152 * self.k_74) - w_389 * w_384 - w_407 - w_390 * w_386
            - c2_on_platform_z * w_408;
        let w_391 = w_364 * w_388 - w_365 * w_389 - c2_on_platform_z * w_390;
        let minus_k_lambda_c2_leg_platform_q3 = w_368 * w_391 / w_367
            + mass_platform_q3_platform_q0 * l_lambda_c2_leg_platform_q0
            + k_platform_q3_platform_q1 * l_lambda_c2_leg_platform_q1
            + k_platform_q3_platform_q2 * l_lambda_c2_leg_platform_q2;
        let w_387 = w_364 * w_383 + w_365 * w_384 + c2_on_platform_z * w_386;
        let w_367_squared = w_367 * w_367;
        let w_392 = w_387
            * ((w_391 * platform_q3_dot - w_378 * platform_q0_dot
                - w_382 * platform_q1_dot - w_373 * platform_q2_dot) / w_367_squared);
        let w_410 = S::from_f64(2.0)
            * (w_392
                + (platform_q0_dot * w_400 + platform_q1_dot * w_403
                    + platform_q2_dot * w_406 - platform_q3_dot * w_409) / w_367);
        let w_411 = w_410
            + (platform_x_dot * w_383 + platform_y_dot * w_384 + platform_z_dot * w_386)
                / w_367
            - w_387
                * ((w_364 * platform_x_dot + w_365 * platform_y_dot
                    + c2_on_platform_z * platform_z_dot) / w_367_squared);
        let w_412 = w_213 + sqrt_w_367 * w_411 - self.k_53 * sin_w_164;
        let c2_leg_by_platform_z = c2_on_platform_z * sqrt_w_367 / w_367;
        let c2_leg_by_platform_x = w_364 * sqrt_w_367 / w_367;
        let c2_leg_by_platform_y = w_365 * sqrt_w_367 / w_367;
        let minus_l_lambda_c2_leg_platform_q3 = inverse_platform_q3
            * minus_k_lambda_c2_leg_platform_q3;
        let k_lambda_c2_leg_lambda_platform_norm = k_lambda_platform_norm_platform_q3
            * minus_l_lambda_c2_leg_platform_q3
            - platform_norm_by_platform_q0 * l_lambda_c2_leg_platform_q0
            - k_lambda_platform_norm_platform_q1 * l_lambda_c2_leg_platform_q1
            - k_lambda_platform_norm_platform_q2 * l_lambda_c2_leg_platform_q2;
        let l_lambda_c2_leg_platform_z = c2_leg_by_platform_z * self.inverse_platform_x;
        let minus_l_lambda_c2_leg_lambda_platform_norm = minus_inverse_lambda_platform_norm
            * k_lambda_c2_leg_lambda_platform_norm;
        let l_lambda_c2_leg_platform_x = c2_leg_by_platform_x * self.inverse_platform_x;
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
        let w_414 = c2_leg_by_platform_q0 * l_lambda_c2_leg_platform_q0
            + k_lambda_c2_leg_platform_q1 * l_lambda_c2_leg_platform_q1
            + k_lambda_c2_leg_platform_q2 * l_lambda_c2_leg_platform_q2
            + minus_k_lambda_c2_leg_platform_q3 * minus_l_lambda_c2_leg_platform_q3
            + c2_leg_by_platform_x * l_lambda_c2_leg_platform_x
            + c2_leg_by_platform_y * l_lambda_c2_leg_platform_y
            + c2_leg_by_platform_z * l_lambda_c2_leg_platform_z;
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
        let w_413 = c1_leg_by_platform_q0 * l_lambda_c1_leg_platform_q0
            + k_lambda_c1_leg_platform_q1 * l_lambda_c1_leg_platform_q1
            + k_lambda_c1_leg_platform_q2 * l_lambda_c1_leg_platform_q2
            + minus_k_lambda_c1_leg_platform_q3 * minus_l_lambda_c1_leg_platform_q3
            + c1_leg_by_platform_x * l_lambda_c1_leg_platform_x
            + c1_leg_by_platform_y * l_lambda_c1_leg_platform_y
            + c1_leg_by_platform_z * l_lambda_c1_leg_platform_z;
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
        let pivot_lambda_c1_leg = k_lambda_c1_leg_lambda_platform_norm
            * minus_l_lambda_c1_leg_lambda_platform_norm - w_413
            - k_lambda_c1_leg_lambda_a1_leg * l_lambda_c1_leg_lambda_a1_leg
            - k_lambda_c1_leg_lambda_a2_leg * l_lambda_c1_leg_lambda_a2_leg
            - k_lambda_c1_leg_lambda_b1_leg * l_lambda_c1_leg_lambda_b1_leg
            - k_lambda_c1_leg_lambda_b2_leg * l_lambda_c1_leg_lambda_b2_leg;
        let inverse_lambda_c1_leg = S::from_f64(1.0) / pivot_lambda_c1_leg;
        let l_lambda_c2_leg_lambda_c1_leg = inverse_lambda_c1_leg
            * k_lambda_c2_leg_lambda_c1_leg;
        let rhs_lambda_c2_leg = l_lambda_c2_leg_platform_q2 * minus_rhs_platform_q2
            - w_412 - rhs_platform_q0 * l_lambda_c2_leg_platform_q0
            - l_lambda_c2_leg_platform_q1 * rhs_platform_q1
            + minus_l_lambda_c2_leg_platform_q3 * rhs_platform_q3
            + self.minus_rhs_platform_z * l_lambda_c2_leg_platform_z
            + minus_l_lambda_c2_leg_lambda_platform_norm * rhs_lambda_platform_norm
            - l_lambda_c2_leg_lambda_a1_leg * rhs_lambda_a1_leg
            - l_lambda_c2_leg_lambda_a2_leg * rhs_lambda_a2_leg
            - l_lambda_c2_leg_lambda_b1_leg * rhs_lambda_b1_leg
            - l_lambda_c2_leg_lambda_b2_leg * rhs_lambda_b2_leg
            - l_lambda_c2_leg_lambda_c1_leg * rhs_lambda_c1_leg;
        let pivot_lambda_c2_leg = k_lambda_c2_leg_lambda_platform_norm
            * minus_l_lambda_c2_leg_lambda_platform_norm - w_414
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
        let w_415 = cos_w_161 * self.k_76;
        let w_416 = self.k_77 * cos_w_162;
        let w_417 = self.k_77 * cos_w_163;
        let w_418 = self.minus_rhs_platform_z * platform_z_dot
            + lambda_a1_leg * cos_w_161 * self.k_78 + lambda_a2_leg * (w_415 - w_416)
            + lambda_b1_leg * (w_415 + w_416) + lambda_b2_leg * (w_415 - w_417)
            + lambda_c1_leg * (w_415 + w_417)
            + lambda_c2_leg * (w_415 - self.k_77 * cos_w_164);
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
            power: -w_418,
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
                ) | sim_kernel::pivot_is_refused(pivot_lambda_a1_leg, w_215)
                | sim_kernel::pivot_is_refused(pivot_lambda_a2_leg, w_264)
                | sim_kernel::pivot_is_refused(pivot_lambda_b1_leg, w_314)
                | sim_kernel::pivot_is_refused(pivot_lambda_b2_leg, w_363)
                | sim_kernel::pivot_is_refused(pivot_lambda_c1_leg, w_413)
                | sim_kernel::pivot_is_refused(pivot_lambda_c2_leg, w_414),
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
    type Entries = [S; 0];
    type Envelope = [S; 0];
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
                    is_length: true,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_x_dot",
                    unit: "m/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_x_ddot",
                    unit: "m/s^2",
                    factor: 1f64,
                    is_length: false,
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
                    is_length: true,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_y_dot",
                    unit: "m/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_y_ddot",
                    unit: "m/s^2",
                    factor: 1f64,
                    is_length: false,
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
                    is_length: true,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_z_dot",
                    unit: "m/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_z_ddot",
                    unit: "m/s^2",
                    factor: 1f64,
                    is_length: false,
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
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_q0_dot",
                    unit: "1/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_q0_ddot",
                    unit: "1/s^2",
                    factor: 1f64,
                    is_length: false,
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
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_q1_dot",
                    unit: "1/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_q1_ddot",
                    unit: "1/s^2",
                    factor: 1f64,
                    is_length: false,
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
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_q2_dot",
                    unit: "1/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_q2_ddot",
                    unit: "1/s^2",
                    factor: 1f64,
                    is_length: false,
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
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "platform_q3_dot",
                    unit: "1/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "platform_q3_ddot",
                    unit: "1/s^2",
                    factor: 1f64,
                    is_length: false,
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
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "A",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Principal moments of inertia of the platform.",
            },
            sim_kernel::Quantity {
                name: "C",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "R",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Radius of the circle of the feet.",
            },
            sim_kernel::Quantity {
                name: "r",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Radius of the circle of the heads.",
            },
            sim_kernel::Quantity {
                name: "foot",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Half of the angle between the feet of a pair.",
            },
            sim_kernel::Quantity {
                name: "head",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Half of the angle between the heads of a pair.",
            },
            sim_kernel::Quantity {
                name: "L",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of the legs at rest.",
            },
            sim_kernel::Quantity {
                name: "heave",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "How far all legs move together.",
            },
            sim_kernel::Quantity {
                name: "sway",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "How far neighbours move against each other.",
            },
            sim_kernel::Quantity {
                name: "w",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "platform_norm",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "a1_leg",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "a2_leg",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "b1_leg",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "b2_leg",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "c1_leg",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "c2_leg",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        speed_constraints: &[],
        norm_constraints: &[0],
        sparsity: &[],
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
                is_length: true,
                docs: "height of the platform",
            },
            sim_kernel::Quantity {
                name: "lean",
                unit: "1",
                factor: 1f64,
                is_length: false,
                docs: "lean of the platform",
            },
            sim_kernel::Quantity {
                name: "force1",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "force2",
                unit: "N",
                factor: 1f64,
                is_length: false,
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
        optional_kernels: &[],
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
