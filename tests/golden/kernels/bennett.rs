/// Bennett's overconstrained linkage, hanging along y from two hinges, its loop cut at the fourth.
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
/// coordinates = [theta1; theta2; theta3]
/// multipliers = [
///     lambda_closure_x;
///     lambda_closure_y;
///     lambda_closure_z;
///     lambda_closure_m1;
///     lambda_closure_m2
/// ]
/// constraints = 0
/// [
///     mass_matrix[1, 1], mass_matrix[1, 2], mass_matrix[1, 3], constraint_jacobian[1, 1], constraint_jacobian[2, 1], 0, constraint_jacobian[4, 1], constraint_jacobian[5, 1];
///     mass_matrix[1, 2], mass_matrix[2, 2], mass_matrix[2, 3], constraint_jacobian[1, 2], constraint_jacobian[2, 2], constraint_jacobian[3, 2], constraint_jacobian[4, 2], constraint_jacobian[5, 2];
///     mass_matrix[1, 3], mass_matrix[2, 3], mass_matrix[3, 3], constraint_jacobian[1, 3], constraint_jacobian[2, 3], a*s_13, constraint_jacobian[4, 3], constraint_jacobian[5, 3];
///     constraint_jacobian[1, 1], constraint_jacobian[1, 2], constraint_jacobian[1, 3], 0, 0, 0, 0, 0;
///     constraint_jacobian[2, 1], constraint_jacobian[2, 2], constraint_jacobian[2, 3], 0, 0, 0, 0, 0;
///     0, constraint_jacobian[3, 2], a*s_13, 0, 0, 0, 0, 0;
///     constraint_jacobian[4, 1], constraint_jacobian[4, 2], constraint_jacobian[4, 3], 0, 0, 0, 0, 0;
///     constraint_jacobian[5, 1], constraint_jacobian[5, 2], constraint_jacobian[5, 3], 0, 0, 0, 0, 0
/// ] * [
///     theta1_ddot;
///     theta2_ddot;
///     theta3_ddot;
///     lambda_closure_x;
///     lambda_closure_y;
///     lambda_closure_z;
///     lambda_closure_m1;
///     lambda_closure_m2
/// ] = [
///     generalized_forces[1] - convective_forces[1];
///     generalized_forces[2] - convective_forces[2];
///     a*m*s_23/2 - convective_forces[3];
///     -constraint_convective[1];
///     -constraint_convective[2];
///     -constraint_convective[3];
///     -constraint_convective[4];
///     -constraint_convective[5]
/// ]
///
/// mass_matrix = [
///     mass_matrix[1, 1], mass_matrix[1, 2], mass_matrix[1, 3];
///     mass_matrix[1, 2], mass_matrix[2, 2], mass_matrix[2, 3];
///     mass_matrix[1, 3], mass_matrix[2, 3], mass_matrix[3, 3]
/// ]
/// mass_matrix[1, 1] = 2*J + a^2*m*cos(alpha)^2*sin(theta2)^2 + J*s_13^2 + J*s_9^2 + m*s_41^2 + a^2*m/4
///     - 0.98*J*sin(alpha)^2*sin(theta2)^2 + m*s_48^2/4 + m*s_49^2/4 + 0.02*J*s_12^2
///     + m*s_52^2/4 + m*s_54^2/4
/// mass_matrix[1, 2] = J*cos(alpha) + J*s_13*sin(beta)*cos(theta3) + J*s_9*cos(beta)
///     + b*m*s_41*cos(beta)*sin(theta3) + b*m*s_48/4 + 0.02*J*s_12*sin(beta)*sin(theta3)
///     + m*s_52*s_53/4 + m*s_54*s_55/4
/// mass_matrix[1, 3] = J*s_9 + a*m*s_52/4
/// mass_matrix[2, 2] = 2*J + b^2*m*cos(beta)^2*sin(theta3)^2 + b^2*m/4 - 0.98*J*sin(beta)^2*sin(theta3)^2
///     + m*s_53^2/4 + m*s_55^2/4
/// mass_matrix[2, 3] = J*cos(beta) + a*m*s_53/4
/// mass_matrix[3, 3] = J + a^2*m/4
///
/// convective_forces = [
///     convective_forces[1];
///     convective_forces[2];
///     convective_forces[3]
/// ]
/// convective_forces[1] = 0.02*J*theta1_dot*theta2_dot*sin(alpha)^2*sin(theta2)*cos(theta2)
///     - 0.02*s_47*sin(alpha)*cos(theta2)
///     + 0.98*J*theta1_dot^2*sin(alpha)^2*cos(alpha)*sin(theta2)*cos(theta2)
///     - a*m*(s_15 + 2*a*theta1_dot^2*cos(theta2))*cos(alpha)*sin(theta2)/2 + m*s_42*s_48/4
///     - b*m*s_33*s_49/4 + 0.02*J*s_12*s_34 - 0.02*s_13*s_50 + 0.02*s_9*s_51 - m*s_41*s_44/2
///     + m*s_45*s_52/4 - m*s_46*s_54/4
/// convective_forces[2] = 0.98*J*theta1_dot^2*sin(alpha)^2*sin(theta2)*cos(theta2) + b*m*s_42/4
///     + 0.02*J*s_34*sin(beta)*sin(theta3) - 0.02*s_50*sin(beta)*cos(theta3)
///     + 0.02*s_51*cos(beta) - b*m*s_44*cos(beta)*sin(theta3)/2 + m*s_45*s_53/4 - m*s_46*s_55/4
/// convective_forces[3] = 0.98*J*s_10*s_11 + s_43 + a*m*s_45/4
///
/// generalized_forces = [
///     generalized_forces[1];
///     generalized_forces[2];
///     a*m*s_23/2
/// ]
/// generalized_forces[1] = a*m*s_18*cos(alpha)*sin(theta2) + m*s_22*s_41 + a*m*g*cos(theta1)/2 + m*s_19*s_48/2
///     + m*g*s_49*sin(alpha)*cos(theta1)/2 + m*s_23*s_52/2 + m*s_21*s_54/2
/// generalized_forces[2] = b*m*s_22*cos(beta)*sin(theta3) + b*m*s_19/2 + m*s_23*s_53/2 + m*s_21*s_55/2
///
/// constraints = [
///     b + P2_x + b*s_1 + s_16;
///     P2_y + b*s_2 + s_17;
///     P3_z + a*s_12;
///     constraints[4];
///     constraints[5]
/// ]
/// constraints[4] = (s_28*cos(theta1) - s_27*sin(theta1))*sin(beta)
///     + (s_26*sin(alpha) + s_25*cos(alpha))*cos(beta)
/// constraints[5] = -(s_29*sin(theta1) + s_31*cos(theta1))*sin(beta)
///     - (s_30*sin(alpha) + cos(alpha)*sin(beta)*sin(theta3))*cos(beta)
///
/// constraint_jacobian = [
///     constraint_jacobian[1, 1], constraint_jacobian[1, 2], constraint_jacobian[1, 3];
///     constraint_jacobian[2, 1], constraint_jacobian[2, 2], constraint_jacobian[2, 3];
///     0, constraint_jacobian[3, 2], a*s_13;
///     constraint_jacobian[4, 1], constraint_jacobian[4, 2], constraint_jacobian[4, 3];
///     constraint_jacobian[5, 1], constraint_jacobian[5, 2], constraint_jacobian[5, 3]
/// ]
/// constraint_jacobian[1, 1] = -P2_y - b*s_2 - s_17
/// constraint_jacobian[1, 2] = -b*s_5 - a*(s_5*cos(theta3) + s_1*cos(beta)*sin(theta3))
/// constraint_jacobian[1, 3] = a*(s_6*cos(theta3) - s_1*sin(theta3))
/// constraint_jacobian[2, 1] = P2_x + b*s_1 + s_16
/// constraint_jacobian[2, 2] = b*s_3 + a*(s_3*cos(theta3) - s_2*cos(beta)*sin(theta3))
/// constraint_jacobian[2, 3] = a*(s_7*cos(theta3) - s_2*sin(theta3))
/// constraint_jacobian[3, 2] = b*sin(alpha)*cos(theta2)
///     + a*(sin(alpha)*cos(theta2)*cos(theta3) - sin(alpha)*sin(theta2)*cos(beta)*sin(theta3))
/// constraint_jacobian[4, 1] = -(s_27*cos(theta1) + s_28*sin(theta1))*sin(beta)
/// constraint_jacobian[4, 2] = -(s_27*cos(theta1)*cos(alpha) + s_26*sin(theta1))*sin(beta) - s_27*sin(alpha)*cos(beta)
/// constraint_jacobian[4, 3] = -(s_71*cos(theta1) + s_72*sin(theta1))*sin(beta)
///     - (s_70*sin(alpha) + cos(alpha)^2*sin(beta)*sin(theta3))*cos(beta)
/// constraint_jacobian[5, 1] = -(s_29*cos(theta1) - s_31*sin(theta1))*sin(beta)
/// constraint_jacobian[5, 2] = (s_30*sin(theta1) - s_29*cos(theta1)*cos(alpha))*sin(beta) - s_29*sin(alpha)*cos(beta)
/// constraint_jacobian[5, 3] = (s_81*sin(theta1) + s_83*cos(theta1))*sin(beta)
///     - (cos(alpha)*sin(beta)*cos(theta3) - s_82*sin(alpha))*cos(beta)
///
/// constraint_convective = [
///     constraint_convective[1];
///     constraint_convective[2];
///     constraint_convective[3];
///     constraint_convective[4];
///     constraint_convective[5]
/// ]
/// constraint_convective[1] = s_59 - theta1_dot*(a*theta1_dot*cos(theta1) + b*s_60 + s_63)
///     - theta2_dot*(b*s_56 + a*s_64)
/// constraint_convective[2] = -theta1_dot*(a*theta1_dot*sin(theta1) + b*s_58 + s_65) - theta2_dot*(b*s_61 + a*s_66)
///     - s_67
/// constraint_convective[3] = -theta2_dot*(b*theta2_dot*sin(alpha)*sin(theta2) + a*s_68) - a*s_69*theta3_dot
/// constraint_convective[4] = -s_75*theta1_dot*sin(beta) - theta2_dot*(s_76*sin(beta) + s_73*sin(alpha)*cos(beta))
///     - s_80*theta3_dot
/// constraint_convective[5] = theta2_dot*(s_86*sin(beta) + s_85*sin(alpha)*cos(beta)) + s_90*theta3_dot
///     + s_91*theta1_dot*sin(beta)
///
/// beta = asin(b*sin(alpha)/a)
/// s_1 = cos(theta1)*cos(theta2) - sin(theta1)*cos(alpha)*sin(theta2)
/// s_2 = sin(theta1)*cos(theta2) + cos(theta1)*cos(alpha)*sin(theta2)
/// s_3 = cos(theta1)*cos(alpha)*cos(theta2) - sin(theta1)*sin(theta2)
/// s_4 = theta1_dot*sin(alpha)*cos(theta2)*cos(beta)
///     + (theta2_dot + theta1_dot*cos(alpha))*sin(beta)
/// s_5 = cos(theta1)*sin(theta2) + sin(theta1)*cos(alpha)*cos(theta2)
/// s_6 = sin(alpha)*sin(theta1)*sin(beta) - s_5*cos(beta)
/// s_7 = s_3*cos(beta) - sin(alpha)*cos(theta1)*sin(beta)
/// s_8 = sin(alpha)*cos(theta2)*cos(beta) + cos(alpha)*sin(beta)
/// s_9 = cos(alpha)*cos(beta) - sin(alpha)*cos(theta2)*sin(beta)
/// s_10 = theta1_dot*sin(alpha)*sin(theta2)*cos(theta3) + s_4*sin(theta3)
/// s_11 = s_4*cos(theta3) - theta1_dot*sin(alpha)*sin(theta2)*sin(theta3)
/// s_12 = sin(alpha)*sin(theta2)*cos(theta3) + s_8*sin(theta3)
/// s_13 = s_8*cos(theta3) - sin(alpha)*sin(theta2)*sin(theta3)
/// s_14 = theta3_dot + (theta2_dot + theta1_dot*cos(alpha))*cos(beta)
///     - theta1_dot*sin(alpha)*cos(theta2)*sin(beta)
/// P2_x = a*cos(theta1)
/// P2_y = a*sin(theta1)
/// P3_z = b*sin(alpha)*sin(theta2)
/// s_15 = b*(theta1_dot^2*sin(alpha)^2*cos(theta2)^2 + (theta2_dot + theta1_dot*cos(alpha))^2)
/// s_16 = a*(s_1*cos(theta3) + s_6*sin(theta3))
/// s_17 = a*(s_2*cos(theta3) + s_7*sin(theta3))
/// s_18 = g*sin(theta1)*cos(theta2) + g*cos(theta1)*cos(alpha)*sin(theta2)
/// s_19 = g*cos(theta1)*cos(alpha)*cos(theta2) - g*sin(theta1)*sin(theta2)
/// s_20 = s_19*cos(beta) - g*sin(alpha)*cos(theta1)*sin(beta)
/// s_21 = s_19*sin(beta) + g*sin(alpha)*cos(theta1)*cos(beta)
/// s_22 = s_18*cos(theta3) + s_20*sin(theta3)
/// s_23 = s_20*cos(theta3) - s_18*sin(theta3)
/// s_24 = cos(alpha)*cos(beta)*cos(theta3) - sin(alpha)*sin(beta)
/// s_25 = cos(alpha)*sin(beta)*cos(theta3) + sin(alpha)*cos(beta)
/// s_26 = s_24*cos(theta2) - cos(alpha)*sin(theta2)*sin(theta3)
/// s_27 = cos(alpha)*cos(theta2)*sin(theta3) + s_24*sin(theta2)
/// s_28 = s_26*cos(alpha) - s_25*sin(alpha)
/// s_29 = cos(theta2)*cos(theta3) - sin(theta2)*cos(beta)*sin(theta3)
/// s_30 = sin(theta2)*cos(theta3) + cos(theta2)*cos(beta)*sin(theta3)
/// s_31 = s_30*cos(alpha) - sin(alpha)*sin(beta)*sin(theta3)
/// s_32 = b*theta1_dot^2*sin(alpha)^2*sin(theta2)*cos(theta2)
/// s_33 = theta1_dot*theta2_dot*sin(alpha)*sin(theta2)
///     + theta1_dot*(theta2_dot + theta1_dot*cos(alpha))*sin(alpha)*sin(theta2)
/// s_34 = s_11*theta3_dot + theta1_dot*theta2_dot*sin(alpha)*cos(theta2)*cos(theta3)
///     - theta1_dot*theta2_dot*sin(alpha)*sin(theta2)*cos(beta)*sin(theta3)
/// s_35 = theta1_dot*theta2_dot*sin(alpha)*sin(theta2)*cos(beta)*cos(theta3)
/// s_36 = theta1_dot*theta2_dot*sin(alpha)*cos(theta2)*sin(theta3)
/// s_37 = (a*theta1_dot^2*sin(theta2) + s_32)*cos(beta) + b*s_33*sin(beta)
/// s_38 = b*cos(alpha) + a*cos(alpha)*cos(theta2)
/// s_39 = b*sin(alpha)*cos(theta2) + a*sin(alpha)
/// s_40 = s_38*cos(beta) - s_39*sin(beta)
/// s_41 = a*cos(alpha)*sin(theta2)*cos(theta3) + s_40*sin(theta3)
/// s_42 = 2*a*theta1_dot^2*sin(theta2) + s_32
/// s_43 = J*theta1_dot*theta2_dot*sin(alpha)*sin(theta2)*sin(beta)
/// s_44 = a*(s_11^2 + s_14^2) - 2*s_37*sin(theta3)
///     + 2*(s_15 + a*theta1_dot^2*cos(theta2))*cos(theta3)
/// s_45 = a*(s_10*s_11 + theta1_dot*theta2_dot*sin(alpha)*sin(theta2)*sin(beta))
///     + 2*(s_15 + a*theta1_dot^2*cos(theta2))*sin(theta3) + 2*s_37*cos(theta3)
/// s_46 = a*(s_10*theta3_dot + s_10*s_14 + s_35 + s_36) + 2*b*s_33*cos(beta)
///     - 2*(a*theta1_dot^2*sin(theta2) + s_32)*sin(beta)
/// s_47 = 49*J*theta1_dot*(theta2_dot + theta1_dot*cos(alpha))*sin(alpha)*sin(theta2)
///     + 50*J*theta1_dot*theta2_dot*sin(alpha)*sin(theta2)
/// s_48 = b*cos(alpha) + 2*a*cos(alpha)*cos(theta2)
/// s_49 = b*sin(alpha)*cos(theta2) + 2*a*sin(alpha)
/// s_50 = 49*J*s_10*s_14 + 50*J*(s_10*theta3_dot + s_35 + s_36)
/// s_51 = 49*J*s_10*s_11 + 50*s_43
/// s_52 = a*s_9 + 2*s_40*cos(theta3) - 2*a*cos(alpha)*sin(theta2)*sin(theta3)
/// s_53 = a*cos(beta) + 2*b*cos(beta)*cos(theta3)
/// s_54 = a*s_13 + 2*s_38*sin(beta) + 2*s_39*cos(beta)
/// s_55 = a*sin(beta)*cos(theta3) + 2*b*sin(beta)
/// s_56 = theta2_dot*cos(theta1)*cos(theta2) - theta1_dot*sin(theta1)*sin(theta2)
///     + theta1_dot*cos(theta1)*cos(alpha)*cos(theta2)
///     - theta2_dot*sin(theta1)*cos(alpha)*sin(theta2)
/// s_57 = theta1_dot*sin(alpha)*cos(theta1)*sin(beta) - s_56*cos(beta)
/// s_58 = theta1_dot*sin(theta1)*cos(theta2) + theta2_dot*cos(theta1)*sin(theta2)
///     + theta1_dot*cos(theta1)*cos(alpha)*sin(theta2)
///     + theta2_dot*sin(theta1)*cos(alpha)*cos(theta2)
/// s_59 = a*theta3_dot*(s_57*cos(theta3) - s_6*theta3_dot*sin(theta3) - s_1*theta3_dot*cos(theta3) + s_58*sin(theta3))
/// s_60 = theta1_dot*cos(theta1)*cos(theta2) - theta2_dot*sin(theta1)*sin(theta2)
///     + theta2_dot*cos(theta1)*cos(alpha)*cos(theta2)
///     - theta1_dot*sin(theta1)*cos(alpha)*sin(theta2)
/// s_61 = theta1_dot*sin(theta1)*cos(alpha)*cos(theta2)
///     + theta2_dot*cos(theta1)*cos(alpha)*sin(theta2) + theta1_dot*cos(theta1)*sin(theta2)
///     + theta2_dot*sin(theta1)*cos(theta2)
/// s_62 = s_61*cos(beta) - theta1_dot*sin(alpha)*sin(theta1)*sin(beta)
/// s_63 = a*(s_60*cos(theta3) - s_2*theta3_dot*sin(theta3) + s_7*theta3_dot*cos(theta3) - s_62*sin(theta3))
/// s_64 = s_56*cos(theta3) - s_5*theta3_dot*sin(theta3) + s_1*theta3_dot*cos(beta)*cos(theta3)
///     - s_58*cos(beta)*sin(theta3)
/// s_65 = a*(s_58*cos(theta3) + s_1*theta3_dot*sin(theta3) - s_57*sin(theta3) - s_6*theta3_dot*cos(theta3))
/// s_66 = s_61*cos(theta3) + s_3*theta3_dot*sin(theta3) + s_60*cos(beta)*sin(theta3)
///     + s_2*theta3_dot*cos(beta)*cos(theta3)
/// s_67 = a*theta3_dot*(s_62*cos(theta3) + s_7*theta3_dot*sin(theta3) + s_60*sin(theta3) + s_2*theta3_dot*cos(theta3))
/// s_68 = theta2_dot*sin(alpha)*sin(theta2)*cos(theta3)
///     + theta3_dot*sin(alpha)*cos(theta2)*sin(theta3)
///     + theta2_dot*sin(alpha)*cos(theta2)*cos(beta)*sin(theta3)
///     + theta3_dot*sin(alpha)*sin(theta2)*cos(beta)*cos(theta3)
/// s_69 = theta2_dot*sin(alpha)*sin(theta2)*cos(beta)*cos(theta3) + s_8*theta3_dot*sin(theta3)
///     + theta2_dot*sin(alpha)*cos(theta2)*sin(theta3)
///     + theta3_dot*sin(alpha)*sin(theta2)*cos(theta3)
/// s_70 = cos(alpha)*cos(theta2)*cos(beta)*sin(theta3) + cos(alpha)*sin(theta2)*cos(theta3)
/// s_71 = s_70*cos(alpha) - sin(alpha)*cos(alpha)*sin(beta)*sin(theta3)
/// s_72 = cos(alpha)*cos(theta2)*cos(theta3) - cos(alpha)*sin(theta2)*cos(beta)*sin(theta3)
/// s_73 = theta3_dot*cos(alpha)*cos(theta2)*cos(theta3)
///     - theta2_dot*cos(alpha)*sin(theta2)*sin(theta3) + s_24*theta2_dot*cos(theta2)
///     - theta3_dot*cos(alpha)*sin(theta2)*cos(beta)*sin(theta3)
/// s_74 = s_24*theta2_dot*sin(theta2) + theta3_dot*cos(alpha)*cos(theta2)*cos(beta)*sin(theta3)
///     + theta2_dot*cos(alpha)*cos(theta2)*sin(theta3)
///     + theta3_dot*cos(alpha)*sin(theta2)*cos(theta3)
/// s_75 = s_73*cos(theta1) - s_27*theta1_dot*sin(theta1) + s_28*theta1_dot*cos(theta1)
///     - (s_74*cos(alpha) - theta3_dot*sin(alpha)*cos(alpha)*sin(beta)*sin(theta3))*sin(theta1)
/// s_76 = s_73*cos(theta1)*cos(alpha) - s_27*theta1_dot*sin(theta1)*cos(alpha)
///     + s_26*theta1_dot*cos(theta1) - s_74*sin(theta1)
/// s_77 = theta3_dot*cos(alpha)*cos(theta2)*cos(beta)*cos(theta3)
///     - theta2_dot*cos(alpha)*sin(theta2)*cos(beta)*sin(theta3)
///     + theta2_dot*cos(alpha)*cos(theta2)*cos(theta3)
///     - theta3_dot*cos(alpha)*sin(theta2)*sin(theta3)
/// s_78 = theta2_dot*cos(alpha)*sin(theta2)*cos(theta3)
///     + theta3_dot*cos(alpha)*cos(theta2)*sin(theta3)
///     + theta2_dot*cos(alpha)*cos(theta2)*cos(beta)*sin(theta3)
///     + theta3_dot*cos(alpha)*sin(theta2)*cos(beta)*cos(theta3)
/// s_79 = (s_77*cos(alpha) - theta3_dot*sin(alpha)*cos(alpha)*sin(beta)*cos(theta3))*cos(theta1)
///     - s_71*theta1_dot*sin(theta1) + s_72*theta1_dot*cos(theta1) - s_78*sin(theta1)
/// s_80 = s_79*sin(beta)
///     + (s_77*sin(alpha) + theta3_dot*cos(alpha)^2*sin(beta)*cos(theta3))*cos(beta)
/// s_81 = cos(theta2)*sin(theta3) + sin(theta2)*cos(beta)*cos(theta3)
/// s_82 = sin(theta2)*sin(theta3) - cos(theta2)*cos(beta)*cos(theta3)
/// s_83 = s_82*cos(alpha) + sin(alpha)*sin(beta)*cos(theta3)
/// s_84 = theta2_dot*cos(theta2)*cos(theta3) - theta3_dot*sin(theta2)*sin(theta3)
///     + theta3_dot*cos(theta2)*cos(beta)*cos(theta3)
///     - theta2_dot*sin(theta2)*cos(beta)*sin(theta3)
/// s_85 = theta2_dot*sin(theta2)*cos(theta3) + theta3_dot*cos(theta2)*sin(theta3)
///     + theta2_dot*cos(theta2)*cos(beta)*sin(theta3)
///     + theta3_dot*sin(theta2)*cos(beta)*cos(theta3)
/// s_86 = s_30*theta1_dot*cos(theta1) + s_84*sin(theta1) + s_29*theta1_dot*sin(theta1)*cos(alpha)
///     + s_85*cos(theta1)*cos(alpha)
/// s_87 = theta3_dot*cos(theta2)*cos(theta3) - theta2_dot*sin(theta2)*sin(theta3)
///     + theta2_dot*cos(theta2)*cos(beta)*cos(theta3)
///     - theta3_dot*sin(theta2)*cos(beta)*sin(theta3)
/// s_88 = theta2_dot*cos(theta2)*sin(theta3) + theta3_dot*sin(theta2)*cos(theta3)
///     + theta2_dot*sin(theta2)*cos(beta)*cos(theta3)
///     + theta3_dot*cos(theta2)*cos(beta)*sin(theta3)
/// s_89 = s_81*theta1_dot*cos(theta1) + s_87*sin(theta1)
///     + (s_88*cos(alpha) - theta3_dot*sin(alpha)*sin(beta)*sin(theta3))*cos(theta1)
///     - s_83*theta1_dot*sin(theta1)
/// s_90 = s_89*sin(beta)
///     + (theta3_dot*cos(alpha)*sin(beta)*sin(theta3) + s_88*sin(alpha))*cos(beta)
/// s_91 = s_29*theta1_dot*sin(theta1) + s_85*cos(theta1) + s_31*theta1_dot*cos(theta1)
///     + (s_84*cos(alpha) - theta3_dot*sin(alpha)*sin(beta)*cos(theta3))*sin(theta1)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Bennett<S = ::core::primitive::f64> {
    /// Length of the first and the third bar, in `m`.
    pub a: S,
    /// Of the second bar and the ground, in `m`.
    pub b: S,
    /// Twist of the first and the third bar, in `1`.
    pub alpha: S,
    /// In `kg`.
    pub m: S,
    /// Moment of inertia of a bar across its axis, in `kg*m^2`.
    pub J: S,
    /// In `m/s^2`.
    pub g: S,
    /// Speed at the first hinge at the start, in `rad/s`.
    pub speed: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Bennett<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`Bennett`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct BennettCoordinates<S = ::core::primitive::f64> {
    /// Turn at the first hinge, in `rad`.
    pub theta1: S,
    /// At the second, in `rad`.
    pub theta2: S,
    /// At the third, in `rad`.
    pub theta3: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for BennettCoordinates<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            theta1: values[0],
            theta2: values[1],
            theta3: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<BennettCoordinates<S>> for [S; 3] {
    fn from(record: BennettCoordinates<S>) -> Self {
        [record.theta1, record.theta2, record.theta3]
    }
}
/// Outputs of [`Bennett`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct BennettOutputs<S = ::core::primitive::f64> {
    /// tan(theta1/2) tan(theta2/2), in `1`.
    pub product: S,
    /// force of the third bar on the ground, in `N`.
    pub force: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for BennettOutputs<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            product: values[0],
            force: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<BennettOutputs<S>> for [S; 2] {
    fn from(record: BennettOutputs<S>) -> Self {
        [record.product, record.force]
    }
}
/// Rates of the outputs of [`Bennett`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct BennettOutputRates<S = ::core::primitive::f64> {
    /// Rate of `product`.
    pub product: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 1]> for BennettOutputRates<S> {
    fn from(values: [S; 1]) -> Self {
        Self { product: values[0] }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<BennettOutputRates<S>> for [S; 1] {
    fn from(record: BennettOutputRates<S>) -> Self {
        [record.product]
    }
}
/// What the equations of motion need of the parameters of [`Bennett`], from [`Bennett::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct BennettPrepared<S = ::core::primitive::f64> {
    J: S,
    a: S,
    m: S,
    cos_alpha: S,
    sin_alpha: S,
    b: S,
    k: S,
    cos_beta: S,
    sin_beta: S,
    k_2: S,
    k_3: S,
    k_4: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    sin_alpha_squared: S,
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
    mass_theta3_theta3: S,
    k_31: S,
    k_32: S,
    k_33: S,
    k_34: S,
    k_35: S,
    k_36: S,
    k_37: S,
    g: S,
    k_38: S,
    k_39: S,
    k_40: S,
    k_41: S,
    k_42: S,
    k_43: S,
    k_44: S,
    k_45: S,
    k_46: S,
    k_47: S,
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
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Bennett<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 5 additions, 84 multiplications, 1 division, 2 sine-cosine pairs, 1 other function.
    #[inline]
    pub fn prepare(&self) -> BennettPrepared<S> {
        let ([sin_alpha], [cos_alpha]) = S::sin_cos_each([self.alpha]);
        let w = sin_alpha * self.b;
        let beta = (w / self.a).asin();
        let ([sin_beta], [cos_beta]) = S::sin_cos_each([beta]);
        let sin_alpha_squared = sin_alpha * sin_alpha;
        let w_2 = S::from_f64(2.0) * self.a;
        let w_3 = self.J * S::from_f64(0.98);
        let w_4 = sin_alpha_squared * w_3;
        let w_5 = self.m * S::from_f64(0.25);
        let w_6 = self.J * S::from_f64(0.02);
        let w_7 = S::from_f64(2.0) * self.J;
        let a_squared = self.a * self.a;
        let w_8 = a_squared * w_5;
        let cos_alpha_squared = cos_alpha * cos_alpha;
        let w_9 = S::from_f64(2.0) * self.b;
        let w_10 = self.m * self.b;
        let b_squared = self.b * self.b;
        let w_11 = self.a * self.m;
        let w_12 = self.J * S::from_f64(49.0);
        let w_13 = self.J * S::from_f64(50.0);
        let w_14 = sin_alpha * w_13;
        let w_15 = S::from_f64(2.0) * self.g;
        let w_16 = sin_alpha * self.g;
        let w_17 = S::from_f64(0.5) * w_11;
        BennettPrepared {
            J: self.J,
            a: self.a,
            m: self.m,
            cos_alpha: cos_alpha,
            sin_alpha: sin_alpha,
            b: self.b,
            k: w,
            cos_beta: cos_beta,
            sin_beta: sin_beta,
            k_2: sin_alpha * cos_beta,
            k_3: cos_alpha * sin_beta,
            k_4: cos_alpha * cos_beta,
            k_5: sin_alpha * sin_beta,
            k_6: cos_alpha * self.b,
            k_7: self.a * cos_alpha,
            k_8: self.a * sin_alpha,
            sin_alpha_squared: sin_alpha_squared,
            k_9: cos_alpha * w_2,
            k_10: sin_alpha * w_2,
            k_11: S::from_f64(2.0) * sin_beta,
            k_12: S::from_f64(2.0) * cos_beta,
            k_13: w_4,
            k_14: w_5,
            k_15: w_6,
            k_16: w_7 + w_8,
            k_17: a_squared * self.m * cos_alpha_squared - w_4,
            k_18: self.a * cos_beta,
            k_19: cos_beta * w_9,
            k_20: self.a * sin_beta,
            k_21: sin_beta * w_9,
            k_22: self.J * cos_alpha,
            k_23: self.J * sin_beta,
            k_24: self.J * cos_beta,
            k_25: cos_beta * w_10,
            k_26: S::from_f64(0.25) * w_10,
            k_27: sin_beta * w_6,
            k_28: w_7 + w_5 * b_squared,
            k_29: self.m * b_squared * cos_beta * cos_beta - w_3 * sin_beta * sin_beta,
            k_30: S::from_f64(0.25) * w_11,
            mass_theta3_theta3: self.J + w_8,
            k_31: cos_alpha * sin_alpha * sin_beta,
            k_32: cos_alpha_squared * sin_beta,
            k_33: sin_alpha * w_12,
            k_34: w_14,
            k_35: w_12,
            k_36: w_13,
            k_37: sin_beta * w_14,
            g: self.g,
            k_38: cos_alpha * w_15,
            k_39: self.b * sin_alpha_squared,
            k_40: sin_alpha * w_15,
            k_41: cos_alpha * self.g,
            k_42: w_16,
            k_43: sin_alpha_squared * w_6,
            k_44: sin_alpha * S::from_f64(0.02),
            k_45: cos_alpha * sin_alpha_squared * w_3,
            k_46: S::from_f64(0.5) * w_11 * self.g,
            k_47: cos_alpha * w_17,
            k_48: self.m * S::from_f64(0.5),
            k_49: sin_beta * S::from_f64(0.02),
            k_50: cos_beta * S::from_f64(0.02),
            k_51: cos_beta * w_10 * S::from_f64(0.5),
            k_52: w_3,
            k_53: self.J * sin_alpha * sin_beta,
            k_54: sin_beta * w_16,
            k_55: cos_beta * w_16,
            k_56: S::from_f64(2.0) * cos_alpha * w_11,
            k_57: S::from_f64(2.0) * self.m,
            k_58: w_11 * self.g,
            k_59: self.m * sin_alpha * self.g,
            k_60: S::from_f64(2.0) * cos_beta * w_10,
            k_61: w_10,
            k_62: w_17,
        }
    }
    /// Mass matrix `T_q' M T_q`, 3 x 3, symmetric, in SI units.
    ///
    /// Operations: 42 additions, 101 multiplications, 1 division, 4 sine-cosine pairs, 1 other function.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 3]) -> [[S; 3]; 3] {
        let [_, theta2, theta3] = *q;
        let w = S::from_f64(2.0) * self.J;
        let a_squared = self.a * self.a;
        let w_2 = self.m * S::from_f64(0.25);
        let w_3 = a_squared * w_2;
        let ([sin_alpha, sin_theta2, sin_theta3], [cos_alpha, cos_theta2, cos_theta3]) = S::sin_cos_each([
            self.alpha,
            theta2,
            theta3,
        ]);
        let w_4 = cos_alpha * self.b;
        let w_5 = S::from_f64(2.0) * self.a;
        let w_6 = cos_alpha * w_5;
        let w_7 = w_4 + cos_theta2 * w_6;
        let w_8 = sin_alpha * self.b;
        let w_9 = cos_theta2 * w_8;
        let w_10 = w_9 + sin_alpha * w_5;
        let w_14 = self.a * sin_alpha + w_9;
        let beta = (w_8 / self.a).asin();
        let ([sin_beta], [cos_beta]) = S::sin_cos_each([beta]);
        let w_11 = cos_alpha * cos_beta - cos_theta2 * sin_alpha * sin_beta;
        let w_12 = self.a * cos_alpha;
        let w_13 = w_4 + cos_theta2 * w_12;
        let w_15 = cos_beta * w_13 - sin_beta * w_14;
        let w_16 = self.a * w_11 + S::from_f64(2.0) * cos_theta3 * w_15
            - sin_theta2 * sin_theta3 * w_6;
        let w_24 = sin_theta2 * cos_theta3 * w_12 + sin_theta3 * w_15;
        let w_17 = cos_alpha * sin_beta + cos_theta2 * sin_alpha * cos_beta;
        let w_18 = sin_theta2 * sin_alpha;
        let w_19 = w_17 * cos_theta3 - sin_theta3 * w_18;
        let w_20 = self.a * w_19 + w_13 * S::from_f64(2.0) * sin_beta
            + w_14 * S::from_f64(2.0) * cos_beta;
        let w_21 = w_2 * (w_7 * w_7 + w_10 * w_10 + w_16 * w_16 + w_20 * w_20);
        let w_25 = cos_theta3 * w_18 + w_17 * sin_theta3;
        let w_22 = self.J * S::from_f64(0.98);
        let w_23 = sin_theta2 * sin_theta2
            * (a_squared * self.m * cos_alpha * cos_alpha
                - sin_alpha * sin_alpha * w_22);
        let w_26 = self.J * S::from_f64(0.02);
        let w_27 = sin_theta3
            * (w_24 * self.m * self.b * cos_beta + w_25 * sin_beta * w_26);
        let w_28 = S::from_f64(2.0) * self.b;
        let w_29 = self.a * cos_beta + cos_theta3 * cos_beta * w_28;
        let w_30 = sin_beta * w_28 + cos_theta3 * self.a * sin_beta;
        let w_31 = self.J * cos_beta;
        let mass_theta2_theta1 = self.J * cos_alpha + w_27
            + w_2 * (w_16 * w_29 + w_20 * w_30) + cos_theta3 * w_19 * self.J * sin_beta
            + w_11 * w_31 + w_7 * self.b * w_2;
        let w_32 = self.a * w_2;
        let mass_theta3_theta1 = self.J * w_11 + w_16 * w_32;
        let mass_theta3_theta2 = w_31 + w_29 * w_32;
        let b_squared = self.b * self.b;
        [
            [
                w + w_3 + w_21 + self.J * (w_19 * w_19 + w_11 * w_11) + w_23
                    + self.m * w_24 * w_24 + w_25 * w_25 * w_26,
                mass_theta2_theta1,
                mass_theta3_theta1,
            ],
            [
                mass_theta2_theta1,
                w + w_2 * b_squared + w_2 * (w_29 * w_29 + w_30 * w_30)
                    + sin_theta3 * sin_theta3
                        * (self.m * b_squared * cos_beta * cos_beta
                            - w_22 * sin_beta * sin_beta),
                mass_theta3_theta2,
            ],
            [mass_theta3_theta1, mass_theta3_theta2, self.J + w_3],
        ]
    }
    /// Convective forces `T_q' M g`, 3, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 66 additions, 173 multiplications, 1 division, 4 sine-cosine pairs, 1 other function.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [_, theta2, theta3] = *q;
        let [theta1_dot, theta2_dot, theta3_dot] = *qd;
        let ([sin_alpha, sin_theta2, sin_theta3], [cos_alpha, cos_theta2, cos_theta3]) = S::sin_cos_each([
            self.alpha,
            theta2,
            theta3,
        ]);
        let w = theta1_dot * theta2_dot;
        let sin_alpha_squared = sin_alpha * sin_alpha;
        let w_2 = S::from_f64(0.02) * self.J;
        let theta1_dot_squared = theta1_dot * theta1_dot;
        let w_3 = self.J * S::from_f64(0.98);
        let w_4 = sin_alpha_squared * w_3;
        let w_5 = theta2_dot + theta1_dot * cos_alpha;
        let w_6 = self.b
            * (w_5 * w_5
                + sin_alpha_squared * theta1_dot_squared * cos_theta2 * cos_theta2);
        let w_7 = self.a * S::from_f64(2.0);
        let w_8 = cos_theta2 * theta1_dot_squared;
        let w_9 = cos_alpha * self.a;
        let w_10 = S::from_f64(0.5) * self.m;
        let w_11 = sin_theta2
            * (cos_theta2
                * (w * sin_alpha_squared * w_2 + theta1_dot_squared * cos_alpha * w_4)
                - (w_6 + w_7 * w_8) * w_9 * w_10);
        let w_13 = cos_theta2 * sin_alpha_squared * self.b;
        let w_14 = sin_theta2 * theta1_dot_squared * (w_7 + w_13);
        let w_19 = sin_theta2 * theta1_dot_squared * (self.a + w_13);
        let w_17 = w_6 + self.a * w_8;
        let w_12 = self.m * S::from_f64(0.25);
        let w_15 = cos_alpha * self.b;
        let w_16 = S::from_f64(2.0) * w_9;
        let w_18 = sin_alpha * self.b;
        let beta = (w_18 / self.a).asin();
        let ([sin_beta], [cos_beta]) = S::sin_cos_each([beta]);
        let w_35 = cos_theta2 * w_18;
        let w_20 = sin_alpha * theta1_dot * sin_theta2 * (theta2_dot + w_5);
        let w_21 = cos_beta * w_19 + w_20 * self.b * sin_beta;
        let w_22 = sin_alpha * cos_beta;
        let w_23 = theta1_dot * cos_theta2;
        let w_24 = w_22 * w_23 + w_5 * sin_beta;
        let w_25 = sin_alpha * sin_theta2;
        let w_26 = theta1_dot * w_25;
        let w_27 = cos_theta3 * w_24 - sin_theta3 * w_26;
        let w_28 = cos_theta3 * w_26 + sin_theta3 * w_24;
        let w_29 = w_27 * w_28;
        let w_30 = sin_alpha * sin_beta;
        let w_40 = theta3_dot + w_5 * cos_beta - w_23 * w_30;
        let w_31 = sin_theta2 * w;
        let w_32 = S::from_f64(2.0) * (sin_theta3 * w_17 + cos_theta3 * w_21)
            + self.a * (w_29 + w_30 * w_31);
        let w_33 = cos_alpha * cos_beta - cos_theta2 * w_30;
        let w_60 = S::from_f64(2.0) * (cos_theta3 * w_17 - sin_theta3 * w_21)
            + self.a * (w_27 * w_27 + w_40 * w_40);
        let w_34 = w_15 + cos_theta2 * w_9;
        let w_36 = sin_alpha * self.a;
        let w_37 = w_35 + w_36;
        let w_38 = cos_beta * w_34 - sin_beta * w_37;
        let w_39 = sin_theta2 * sin_theta3;
        let w_41 = sin_theta2 * cos_theta3;
        let w_61 = (w_9 * w_41 + sin_theta3 * w_38) * w_60 * w_10;
        let w_42 = sin_alpha * cos_theta2;
        let w_43 = w_22 * w_41 + sin_theta3 * w_42;
        let w_59 = theta1_dot * theta2_dot * (cos_theta3 * w_42 - w_22 * w_39)
            + theta3_dot * w_27;
        let w_48 = cos_alpha * sin_beta + cos_theta2 * w_22;
        let w_62 = sin_theta3
            * (w_59 * sin_beta * w_2 - w_60 * self.b * cos_beta * w_10);
        let w_44 = self.b * S::from_f64(2.0);
        let w_45 = cos_beta * w_44;
        let w_46 = S::from_f64(2.0) * sin_beta;
        let w_47 = self.a * (w_28 * (theta3_dot + w_40) + w_43 * w) + w_20 * w_45
            - w_19 * w_46;
        let w_63 = w_12
            * (w_32 * (self.a * cos_beta + cos_theta3 * w_45)
                - w_47 * (sin_beta * w_44 + cos_theta3 * self.a * sin_beta));
        let w_49 = cos_theta3 * w_48 - sin_theta3 * w_25;
        let w_50 = w_47
            * (self.a * w_49 + w_34 * w_46 + w_37 * S::from_f64(2.0) * cos_beta);
        let w_51 = w_12
            * (w_14 * (w_15 + cos_theta2 * w_16)
                + w_32
                    * (self.a * w_33 + S::from_f64(2.0) * cos_theta3 * w_38
                        - w_16 * w_39) - w_50);
        let w_52 = self.J * S::from_f64(49.0);
        let w_56 = w_28 * w_40 * w_52
            + (theta1_dot * theta2_dot * w_43 + theta3_dot * w_28) * self.J
                * S::from_f64(50.0);
        let w_53 = self.J * sin_alpha;
        let w_54 = S::from_f64(50.0) * w_53;
        let w_55 = w_52 * w_29 + w_54 * sin_beta * w_31;
        let w_57 = cos_theta2 * theta1_dot * sin_theta2
            * (w_5 * S::from_f64(49.0) * w_53 + theta2_dot * w_54) * S::from_f64(0.02)
            * sin_alpha;
        let w_58 = self.b * w_12;
        [
            w_11 + w_51 + S::from_f64(0.02) * (w_33 * w_55 - w_49 * w_56) - w_57
                - w_20 * (S::from_f64(2.0) * w_36 + w_35) * w_58
                + (cos_theta3 * w_25 + w_48 * sin_theta3) * w_59 * w_2 - w_61,
            w_62 + w_63 + sin_theta2 * w_8 * w_4 + w_14 * w_58
                - cos_theta3 * w_56 * S::from_f64(0.02) * sin_beta
                + w_55 * S::from_f64(0.02) * cos_beta,
            w_29 * w_3 + w_31 * w_53 * sin_beta + w_32 * self.a * w_12,
        ]
    }
    /// Generalised forces `T_q' F`, 3: joules per unit of each coordinate.
    ///
    /// Operations: 30 additions, 87 multiplications, 1 division, 5 sine-cosine pairs, 1 other function.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [theta1, theta2, theta3] = *q;
        let w = self.m * S::from_f64(0.5);
        let (
            [sin_alpha,
            sin_theta2,
            sin_theta1,
            sin_theta3,
            ],
            [cos_alpha,
            cos_theta2,
            cos_theta1,
            cos_theta3,
            ],
        ) = S::sin_cos_each([self.alpha, theta2, theta1, theta3]);
        let w_2 = cos_alpha * self.g;
        let w_3 = self.g * sin_theta1;
        let w_4 = cos_theta2 * cos_theta1 * w_2 - sin_theta2 * w_3;
        let w_11 = cos_theta2 * w_3 + sin_theta2 * cos_theta1 * w_2;
        let w_5 = cos_alpha * self.b;
        let w_6 = self.a * S::from_f64(2.0);
        let w_7 = cos_alpha * w_6;
        let w_8 = self.b * sin_alpha;
        let beta = (w_8 / self.a).asin();
        let ([sin_beta], [cos_beta]) = S::sin_cos_each([beta]);
        let w_15 = cos_theta2 * w_8;
        let w_22 = cos_theta1
            * (self.a * self.g * w + (w_15 + sin_alpha * w_6) * self.g * sin_alpha * w);
        let w_16 = self.a * sin_alpha + w_15;
        let w_9 = self.g * sin_alpha;
        let w_10 = cos_beta * w_4 - cos_theta1 * sin_beta * w_9;
        let w_19 = w_4 * sin_beta + cos_theta1 * cos_beta * w_9;
        let w_12 = cos_theta3 * w_10 - w_11 * sin_theta3;
        let w_23 = w_11 * cos_theta3 + sin_theta3 * w_10;
        let w_13 = self.a * cos_alpha;
        let w_14 = w_5 + cos_theta2 * w_13;
        let w_17 = cos_beta * w_14 - sin_beta * w_16;
        let w_18 = sin_theta2 * sin_theta3;
        let w_20 = w_19
            * (self.a
                * (cos_theta3
                    * (cos_alpha * sin_beta + cos_theta2 * sin_alpha * cos_beta)
                    - sin_alpha * w_18) + w_14 * sin_beta * S::from_f64(2.0)
                + w_16 * cos_beta * S::from_f64(2.0));
        let w_21 = w_4 * (w_5 + cos_theta2 * w_7)
            + w_12
                * (self.a * (cos_alpha * cos_beta - cos_theta2 * sin_alpha * sin_beta)
                    + cos_theta3 * w_17 * S::from_f64(2.0) - w_7 * w_18) + w_20;
        let w_24 = self.b * S::from_f64(2.0);
        let w_25 = w
            * (w_12 * (self.a * cos_beta + cos_theta3 * cos_beta * w_24)
                + w_19 * (sin_beta * w_24 + cos_theta3 * self.a * sin_beta));
        [
            w * w_21 + w_22 + sin_theta2 * w_11 * self.a * self.m * cos_alpha
                + self.m * w_23 * (sin_theta2 * cos_theta3 * w_13 + sin_theta3 * w_17),
            w_25 + sin_theta3 * w_23 * self.m * self.b * cos_beta + w_4 * self.b * w,
            w_12 * self.a * w,
        ]
    }
    /// Constraints `C`, 5, in SI units; zero throughout the motion.
    ///
    /// Operations: 31 additions, 60 multiplications, 1 division, 5 sine-cosine pairs, 1 other function.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 3]) -> [S; 5] {
        let [theta1, theta2, theta3] = *q;
        let (
            [sin_theta1,
            sin_theta2,
            sin_alpha,
            sin_theta3,
            ],
            [cos_theta1,
            cos_theta2,
            cos_alpha,
            cos_theta3,
            ],
        ) = S::sin_cos_each([theta1, theta2, self.alpha, theta3]);
        let w = cos_alpha * sin_theta2;
        let w_2 = cos_theta1 * cos_theta2 - sin_theta1 * w;
        let w_3 = self.b * sin_alpha;
        let beta = (w_3 / self.a).asin();
        let ([sin_beta], [cos_beta]) = S::sin_cos_each([beta]);
        let w_4 = sin_alpha * sin_beta;
        let w_5 = cos_theta2 * cos_alpha;
        let w_6 = cos_theta2 * sin_theta1 + cos_theta1 * w;
        let w_7 = sin_theta2 * cos_theta3;
        let w_8 = cos_alpha * sin_beta;
        let w_9 = sin_alpha * cos_beta;
        let w_10 = cos_theta3 * cos_alpha * cos_beta - w_4;
        let w_11 = cos_theta2 * w_10 - w * sin_theta3;
        let w_12 = w_9 + cos_theta3 * w_8;
        let w_13 = w_7 + cos_theta2 * cos_beta * sin_theta3;
        let w_14 = sin_beta
            * (sin_theta1
                * (cos_theta2 * cos_theta3 - sin_theta2 * cos_beta * sin_theta3)
                + cos_theta1 * (cos_alpha * w_13 - w_4 * sin_theta3));
        [
            self.b * (S::from_f64(1.0) + w_2)
                + self.a
                    * (cos_theta1
                        + (w_2 * cos_theta3
                            + (sin_theta1 * w_4
                                - cos_beta * (cos_theta1 * sin_theta2 + sin_theta1 * w_5))
                                * sin_theta3)),
            self.a
                * (sin_theta1
                    + (cos_theta3 * w_6
                        + sin_theta3
                            * (cos_beta * (cos_theta1 * w_5 - sin_theta1 * sin_theta2)
                                - cos_theta1 * w_4))) + self.b * w_6,
            sin_theta2 * w_3
                + self.a * (sin_alpha * w_7 + sin_theta3 * (w_8 + cos_theta2 * w_9)),
            sin_beta
                * (cos_theta1 * (cos_alpha * w_11 - sin_alpha * w_12)
                    - sin_theta1 * (w_5 * sin_theta3 + sin_theta2 * w_10))
                + cos_beta * (sin_alpha * w_11 + cos_alpha * w_12),
            -(w_14 + cos_beta * (sin_alpha * w_13 + sin_theta3 * w_8)),
        ]
    }
    /// The sum of the magnitudes of the terms of `C`, 5, in SI units: what its rounding is relative to.
    ///
    /// Operations: 43 additions, 62 multiplications, 1 division, 5 sine-cosine pairs, 1 other function.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 3]) -> [S; 5] {
        let [theta1, theta2, theta3] = *q;
        let (
            [sin_theta1,
            sin_theta2,
            sin_alpha,
            sin_theta3,
            ],
            [cos_theta1,
            cos_theta2,
            cos_alpha,
            cos_theta3,
            ],
        ) = S::sin_cos_each([theta1, theta2, self.alpha, theta3]);
        let w = cos_alpha * sin_theta2;
        let w_2 = cos_theta1 * cos_theta2 - sin_theta1 * w;
        let w_3 = self.b * sin_alpha;
        let beta = (w_3 / self.a).asin();
        let ([sin_beta], [cos_beta]) = S::sin_cos_each([beta]);
        let w_4 = sin_alpha * sin_beta;
        let w_5 = cos_theta2 * cos_alpha;
        let w_6 = (self.a
            * (w_2 * cos_theta3
                + (sin_theta1 * w_4
                    - cos_beta * (cos_theta1 * sin_theta2 + sin_theta1 * w_5))
                    * sin_theta3))
            .abs();
        let w_7 = cos_theta2 * sin_theta1 + cos_theta1 * w;
        let w_8 = (self.a
            * (cos_theta3 * w_7
                + sin_theta3
                    * (cos_beta * (cos_theta1 * w_5 - sin_theta1 * sin_theta2)
                        - cos_theta1 * w_4)))
            .abs();
        let w_9 = sin_theta2 * cos_theta3;
        let w_10 = cos_alpha * sin_beta;
        let w_11 = sin_alpha * cos_beta;
        let w_12 = cos_theta3 * cos_alpha * cos_beta - w_4;
        let w_13 = cos_theta2 * w_12 - w * sin_theta3;
        let w_14 = w_11 + cos_theta3 * w_10;
        let w_15 = (sin_beta
            * (cos_theta1 * (cos_alpha * w_13 - sin_alpha * w_14)
                - sin_theta1 * (w_5 * sin_theta3 + sin_theta2 * w_12)))
            .abs();
        let w_16 = w_9 + cos_theta2 * cos_beta * sin_theta3;
        let w_17 = (sin_beta
            * (sin_theta1
                * (cos_theta2 * cos_theta3 - sin_theta2 * cos_beta * sin_theta3)
                + cos_theta1 * (cos_alpha * w_16 - w_4 * sin_theta3)))
            .abs();
        [
            self.b.abs() + (self.a * cos_theta1).abs() + (self.b * w_2).abs() + w_6,
            (self.a * sin_theta1).abs() + (self.b * w_7).abs() + w_8,
            (sin_theta2 * w_3).abs()
                + (self.a * (sin_alpha * w_9 + sin_theta3 * (w_10 + cos_theta2 * w_11)))
                    .abs(),
            w_15 + (cos_beta * (sin_alpha * w_13 + cos_alpha * w_14)).abs(),
            w_17 + (cos_beta * (sin_alpha * w_16 + sin_theta3 * w_10)).abs(),
        ]
    }
    /// Constraint Jacobian `C_q`, 5 x 3: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 54 additions, 105 multiplications, 1 division, 5 sine-cosine pairs, 1 other function.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 3]) -> [[S; 3]; 5] {
        let [theta1, theta2, theta3] = *q;
        let (
            [sin_alpha,
            sin_theta2,
            sin_theta3,
            sin_theta1,
            ],
            [cos_alpha,
            cos_theta2,
            cos_theta3,
            cos_theta1,
            ],
        ) = S::sin_cos_each([self.alpha, theta2, theta3, theta1]);
        let w = cos_alpha * sin_theta2;
        let w_2 = cos_theta2 * sin_theta1 + cos_theta1 * w;
        let w_3 = sin_alpha * self.b;
        let beta = (w_3 / self.a).asin();
        let ([sin_beta], [cos_beta]) = S::sin_cos_each([beta]);
        let w_4 = cos_alpha * cos_theta2;
        let w_5 = cos_theta1 * w_4 - sin_theta2 * sin_theta1;
        let w_6 = sin_alpha * sin_beta;
        let w_7 = cos_beta * w_5 - w_6 * cos_theta1;
        let w_8 = sin_theta2 * cos_theta1 + sin_theta1 * w_4;
        let w_9 = cos_theta2 * cos_theta1 - sin_theta1 * w;
        let w_10 = sin_theta3 * w_9;
        let w_11 = w_6 * sin_theta1 - cos_beta * w_8;
        let w_12 = sin_theta3 * w_2;
        let w_13 = cos_theta2 * cos_theta3;
        let w_14 = sin_alpha * cos_beta;
        let w_15 = sin_theta2 * sin_theta3;
        let w_16 = cos_alpha * sin_beta;
        let w_17 = cos_alpha * cos_beta;
        let w_18 = cos_theta3 * w_17 - w_6;
        let w_19 = sin_theta3 * w_4 + sin_theta2 * w_18;
        let w_20 = cos_theta2 * w_18 - cos_alpha * w_15;
        let w_21 = w_16 * cos_theta3;
        let w_22 = cos_alpha * cos_theta1;
        let w_23 = cos_theta2 * sin_theta3;
        let w_24 = w_17 * w_23 + cos_theta3 * w;
        let w_25 = sin_beta
            * (cos_theta1
                * (cos_alpha * w_24 - sin_theta3 * cos_alpha * sin_alpha * sin_beta)
                + sin_theta1 * (cos_theta3 * w_4 - w_15 * w_17));
        let w_26 = w_13 - cos_beta * w_15;
        let w_27 = sin_theta2 * cos_theta3;
        let w_28 = w_27 + cos_beta * w_23;
        let w_29 = w_15 - cos_beta * w_13;
        [
            [
                -(self.a * (sin_theta1 + (cos_theta3 * w_2 + sin_theta3 * w_7))
                    + self.b * w_2),
                -(self.b * w_8 + self.a * (cos_theta3 * w_8 + cos_beta * w_10)),
                self.a * (cos_theta3 * w_11 - w_10),
            ],
            [
                self.a * (cos_theta1 + (cos_theta3 * w_9 + sin_theta3 * w_11))
                    + self.b * w_9,
                self.b * w_5 + self.a * (cos_theta3 * w_5 - cos_beta * w_12),
                self.a * (cos_theta3 * w_7 - w_12),
            ],
            [
                S::from_f64(0.0),
                cos_theta2 * w_3 + self.a * (sin_alpha * w_13 - w_14 * w_15),
                self.a * ((w_16 + cos_theta2 * w_14) * cos_theta3 - sin_alpha * w_15),
            ],
            [
                -(sin_beta
                    * (cos_theta1 * w_19
                        + sin_theta1 * (cos_alpha * w_20 - sin_alpha * (w_14 + w_21)))),
                -(sin_beta * (w_19 * w_22 + sin_theta1 * w_20) + w_14 * w_19),
                -(w_25
                    + cos_beta
                        * (sin_alpha * w_24
                            + sin_theta3 * cos_alpha * cos_alpha * sin_beta)),
            ],
            [
                -(sin_beta
                    * (cos_theta1 * w_26
                        - sin_theta1 * (cos_alpha * w_28 - sin_theta3 * w_6))),
                sin_beta * (sin_theta1 * w_28 - w_22 * w_26) - w_14 * w_26,
                sin_beta
                    * (sin_theta1 * (w_23 + cos_beta * w_27)
                        + cos_theta1 * (cos_alpha * w_29 + cos_theta3 * w_6))
                    - cos_beta * (w_21 - sin_alpha * w_29),
            ],
        ]
    }
    /// `C_t`, 5, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 3]) -> [S; 5] {
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
        ]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 5, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 91 additions, 201 multiplications, 1 division, 5 sine-cosine pairs, 1 other function.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 5] {
        let [theta1, theta2, theta3] = *q;
        let [theta1_dot, theta2_dot, theta3_dot] = *qd;
        let (
            [sin_theta3,
            sin_alpha,
            sin_theta1,
            sin_theta2,
            ],
            [cos_theta3,
            cos_alpha,
            cos_theta1,
            cos_theta2,
            ],
        ) = S::sin_cos_each([theta3, self.alpha, theta1, theta2]);
        let w = sin_alpha * self.b;
        let beta = (w / self.a).asin();
        let ([sin_beta], [cos_beta]) = S::sin_cos_each([beta]);
        let w_2 = self.a * cos_beta;
        let theta3_dot_squared = theta3_dot * theta3_dot;
        let theta1_dot_squared = theta1_dot * theta1_dot;
        let theta2_dot_squared = theta2_dot * theta2_dot;
        let w_3 = theta1_dot_squared + theta2_dot_squared;
        let w_4 = theta3_dot_squared + w_3;
        let w_5 = self.a * S::from_f64(2.0);
        let w_6 = cos_alpha * S::from_f64(2.0);
        let w_7 = self.a * w_6;
        let w_8 = w_2 * w_6;
        let w_9 = theta1_dot * theta2_dot;
        let w_10 = sin_theta2 * sin_theta3
            * (w_2 * w_4 + theta3_dot * (theta2_dot * w_5 + theta1_dot * w_7)
                + w_8 * w_9);
        let w_11 = S::from_f64(2.0) * w_2;
        let w_12 = theta3_dot * (theta2_dot * w_11 + theta1_dot * w_8);
        let w_22 = cos_theta3
            * (theta3_dot * (theta1_dot * w_11 + theta2_dot * w_8)
                + self.a * cos_alpha * w_4 + w_5 * w_9) + self.b * S::from_f64(2.0) * w_9
            + self.b * cos_alpha * w_3;
        let w_23 = sin_theta2 * w_22;
        let w_24 = cos_theta2
            * (theta3_dot * (theta1_dot * w_5 + theta2_dot * w_7) + cos_alpha * w_2 * w_4
                + w_11 * w_9);
        let w_13 = w_7 * w_9;
        let w_14 = self.b * w_3;
        let w_15 = self.b * w_6 * w_9;
        let w_16 = sin_alpha * S::from_f64(2.0);
        let w_17 = self.a * sin_beta;
        let w_18 = theta3_dot * cos_theta3;
        let w_19 = theta1_dot * w_16 * w_17 * w_18;
        let w_20 = self.a * theta1_dot_squared;
        let w_21 = cos_theta1
            * (w_10
                - cos_theta2
                    * (cos_theta3
                        * (self.a
                            * (theta3_dot_squared + theta1_dot_squared
                                + theta2_dot_squared) + w_12 + w_13) + w_14 + w_15) + w_19
                - w_20);
        let w_27 = sin_theta1
            * (w_10 + w_19 - w_20
                - cos_theta2
                    * (w_14 + w_15 + cos_theta3 * (w_12 + w_13 + self.a * w_4)));
        let w_25 = theta3_dot_squared + theta1_dot_squared;
        let w_26 = sin_alpha * w_17 * w_25;
        let w_28 = theta3_dot_squared + theta2_dot_squared;
        let w_29 = theta3_dot * theta2_dot;
        let w_30 = sin_theta3
            * (cos_theta2 * (self.a * w_16 * w_29 + sin_alpha * w_2 * w_28)
                + theta3_dot_squared * cos_alpha * w_17);
        let sin_beta_squared = sin_beta * sin_beta;
        let w_31 = theta1_dot * w_16 * sin_beta_squared;
        let cos_alpha_squared = cos_alpha * cos_alpha;
        let w_32 = sin_beta * S::from_f64(2.0);
        let w_33 = cos_alpha_squared * w_32;
        let w_34 = sin_beta * cos_beta;
        let w_35 = cos_alpha_squared * w_34;
        let w_36 = sin_alpha * cos_alpha;
        let w_37 = sin_beta_squared * w_36;
        let w_38 = cos_theta2
            * (theta2_dot * (w_31 - w_18 * w_33) - cos_theta3 * w_4 * w_35 + w_3 * w_37);
        let w_39 = theta2_dot * sin_theta3;
        let w_40 = cos_theta2 * w_18 - sin_theta2 * w_39;
        let w_58 = cos_theta2 * w_39 + sin_theta2 * w_18;
        let w_41 = sin_beta * w_6;
        let w_45 = w_6 * w_34;
        let w_42 = cos_theta3 * theta2_dot;
        let w_43 = theta3_dot * sin_theta3;
        let w_44 = cos_theta2 * w_42 - sin_theta2 * w_43;
        let w_57 = sin_theta2 * w_42 + cos_theta2 * w_43;
        let w_46 = S::from_f64(2.0) * w_34;
        let w_47 = cos_alpha_squared * w_46;
        let w_48 = sin_alpha * sin_alpha * w_34;
        let w_49 = w_38 - theta1_dot * (w_40 * w_41 + w_44 * w_45)
            + sin_theta2 * sin_theta3
                * (w_4 * sin_beta * cos_alpha_squared + w_29 * w_47)
            + cos_theta3 * w_25 * w_37 + theta1_dot_squared * w_48;
        let w_61 = theta1_dot_squared + w_28;
        let w_50 = cos_alpha * w_34;
        let w_51 = w_29 * w_41;
        let w_52 = sin_alpha * sin_beta_squared;
        let w_53 = cos_alpha * w_16;
        let w_54 = sin_beta_squared * w_53;
        let w_55 = sin_beta * cos_alpha;
        let w_56 = sin_theta3
            * (cos_theta2 * (w_4 * w_55 + w_29 * w_45) - theta3_dot * theta1_dot * w_54);
        let w_59 = sin_theta1
            * (sin_theta2 * (cos_theta3 * (w_4 * w_50 + w_51) - w_3 * w_52 - w_9 * w_54)
                + w_56 + theta1_dot * (w_57 * w_47 + w_58 * w_33));
        let cos_beta_squared = cos_beta * cos_beta;
        let w_60 = cos_theta3
            * (cos_theta2 * (w_29 * cos_beta * w_53 + w_28 * cos_beta_squared * w_36)
                + theta3_dot_squared * w_35);
        let w_62 = cos_theta2
            * (cos_theta1 * (w_51 + w_50 * w_61) + w_29 * cos_beta * w_16
                + w_28 * sin_alpha * cos_beta_squared);
        let w_63 = sin_theta3
            * (w_62 - sin_theta1 * sin_theta2 * (w_29 * w_32 + w_34 * w_61)
                - cos_theta1 * w_25 * w_52 + theta3_dot_squared * w_50);
        let w_64 = cos_theta2 * sin_theta1;
        let w_65 = theta3_dot
            * (theta2_dot
                * (sin_theta2 * (w_16 * cos_beta_squared + cos_theta1 * w_45)
                    + w_46 * w_64) - sin_theta1 * w_31);
        let w_66 = cos_theta3
            * (w_65 + w_61 * (sin_beta * w_64 + cos_theta1 * sin_theta2 * w_55)
                + sin_theta2 * sin_alpha * cos_beta * w_28);
        [
            w_21 + sin_theta1 * (w_23 + sin_theta3 * (w_24 - w_26)),
            w_27 + cos_theta1 * (sin_theta3 * (w_26 - w_24) - w_23),
            -(sin_theta2
                * (cos_theta3 * (self.a * sin_alpha * w_28 + w_16 * w_2 * w_29)
                    + w * theta2_dot_squared) + w_30),
            cos_theta1 * w_49 + w_59 - w_60
                + sin_theta2 * sin_theta3
                    * (w_28 * cos_beta * w_36 + w_29 * cos_beta_squared * w_53)
                + cos_theta2 * theta2_dot_squared * w_48,
            w_63 + w_66
                + theta1_dot
                    * (cos_theta1 * (w_57 * w_32 + w_58 * w_46)
                        + sin_theta1 * (w_44 * w_41 + w_40 * w_45)),
        ]
    }
    /// `C` (5), `C_q` (5 x 3) and `C_t` (5) together, in SI units, for projection.
    ///
    /// Operations: 65 additions, 120 multiplications, 1 division, 5 sine-cosine pairs, 1 other function.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 3],
    ) -> sim_kernel::ConstraintLinearization<[S; 5], [[S; 3]; 5]> {
        let [theta1, theta2, theta3] = *q;
        let (
            [sin_theta1,
            sin_theta2,
            sin_alpha,
            sin_theta3,
            ],
            [cos_theta1,
            cos_theta2,
            cos_alpha,
            cos_theta3,
            ],
        ) = S::sin_cos_each([theta1, theta2, self.alpha, theta3]);
        let w = sin_theta1 * sin_theta2;
        let w_2 = cos_theta1 * cos_theta2 - cos_alpha * w;
        let w_3 = self.b * sin_alpha;
        let beta = (w_3 / self.a).asin();
        let ([sin_beta], [cos_beta]) = S::sin_cos_each([beta]);
        let w_4 = sin_alpha * sin_beta;
        let w_5 = cos_theta2 * sin_theta1;
        let w_6 = cos_theta1 * sin_theta2 + cos_alpha * w_5;
        let w_7 = sin_theta1 * w_4 - cos_beta * w_6;
        let w_8 = self.a * (cos_theta1 + (w_2 * cos_theta3 + w_7 * sin_theta3));
        let w_9 = cos_theta1 * cos_alpha;
        let w_10 = w_5 + sin_theta2 * w_9;
        let w_11 = cos_theta2 * w_9 - w;
        let w_12 = cos_beta * w_11 - cos_theta1 * w_4;
        let minus_closure_x_by_theta1 = self.a
            * (sin_theta1 + (cos_theta3 * w_10 + sin_theta3 * w_12)) + self.b * w_10;
        let w_31 = sin_theta3 * w_10;
        let w_13 = sin_theta2 * cos_theta3;
        let w_14 = cos_alpha * sin_beta;
        let w_15 = sin_alpha * cos_beta;
        let w_16 = w_14 + cos_theta2 * w_15;
        let w_17 = cos_alpha * cos_beta;
        let w_18 = cos_theta3 * w_17 - w_4;
        let w_19 = sin_theta2 * sin_theta3;
        let w_20 = cos_theta2 * w_18 - cos_alpha * w_19;
        let w_21 = cos_theta3 * w_14;
        let w_22 = w_15 + w_21;
        let w_23 = cos_alpha * w_20 - sin_alpha * w_22;
        let w_24 = cos_theta2 * sin_theta3;
        let w_25 = cos_alpha * w_24 + sin_theta2 * w_18;
        let w_26 = cos_theta2 * cos_theta3;
        let w_27 = w_26 - cos_beta * w_19;
        let w_28 = w_13 + cos_beta * w_24;
        let w_29 = cos_alpha * w_28 - w_4 * sin_theta3;
        let w_30 = w_2 * sin_theta3;
        let w_32 = w_17 * w_24 + cos_alpha * w_13;
        let w_33 = sin_beta
            * (cos_theta1
                * (cos_alpha * w_32 - sin_theta3 * cos_alpha * sin_alpha * sin_beta)
                + sin_theta1 * (cos_alpha * w_26 - w_17 * w_19));
        let w_34 = w_19 - cos_beta * w_26;
        sim_kernel::ConstraintLinearization {
            values: [
                self.b * (S::from_f64(1.0) + w_2) + w_8,
                minus_closure_x_by_theta1,
                sin_theta2 * w_3 + self.a * (sin_alpha * w_13 + sin_theta3 * w_16),
                sin_beta * (cos_theta1 * w_23 - sin_theta1 * w_25)
                    + cos_beta * (sin_alpha * w_20 + cos_alpha * w_22),
                -(sin_beta * (sin_theta1 * w_27 + cos_theta1 * w_29)
                    + cos_beta * (sin_alpha * w_28 + sin_theta3 * w_14)),
            ],
            jacobian: [
                [
                    -minus_closure_x_by_theta1,
                    -(self.b * w_6 + self.a * (cos_theta3 * w_6 + cos_beta * w_30)),
                    self.a * (cos_theta3 * w_7 - w_30),
                ],
                [
                    w_8 + self.b * w_2,
                    self.b * w_11 + self.a * (cos_theta3 * w_11 - cos_beta * w_31),
                    self.a * (cos_theta3 * w_12 - w_31),
                ],
                [
                    S::from_f64(0.0),
                    cos_theta2 * w_3 + self.a * (sin_alpha * w_26 - w_15 * w_19),
                    self.a * (cos_theta3 * w_16 - sin_alpha * w_19),
                ],
                [
                    -(sin_beta * (cos_theta1 * w_25 + sin_theta1 * w_23)),
                    -(sin_beta * (w_9 * w_25 + sin_theta1 * w_20) + w_15 * w_25),
                    -(w_33
                        + cos_beta
                            * (sin_alpha * w_32
                                + sin_theta3 * sin_beta * cos_alpha * cos_alpha)),
                ],
                [
                    -(sin_beta * (cos_theta1 * w_27 - sin_theta1 * w_29)),
                    sin_beta * (sin_theta1 * w_28 - w_9 * w_27) - w_15 * w_27,
                    sin_beta
                        * (sin_theta1 * (w_24 + cos_beta * w_13)
                            + cos_theta1 * (cos_alpha * w_34 + cos_theta3 * w_4))
                        - cos_beta * (w_21 - sin_alpha * w_34),
                ],
            ],
            time_derivative: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 29 additions, 72 multiplications, 1 division, 4 sine-cosine pairs, 1 other function.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        let [_, theta2, theta3] = *q;
        let [theta1_dot, theta2_dot, theta3_dot] = *qd;
        let w = self.m * S::from_f64(0.125);
        let ([sin_alpha, sin_theta2, sin_theta3], [cos_alpha, cos_theta2, cos_theta3]) = S::sin_cos_each([
            self.alpha,
            theta2,
            theta3,
        ]);
        let w_2 = theta2_dot + theta1_dot * cos_alpha;
        let w_3 = w_2 * self.b;
        let w_4 = theta1_dot * cos_theta2;
        let w_5 = self.a * S::from_f64(2.0);
        let w_6 = cos_alpha * w_5;
        let w_7 = w_3 + w_4 * w_6;
        let w_8 = sin_alpha * self.b;
        let w_9 = cos_theta2 * w_8;
        let w_10 = theta1_dot * (w_9 + sin_alpha * w_5);
        let w_14 = theta1_dot * (self.a * sin_alpha + w_9);
        let beta = (w_8 / self.a).asin();
        let ([sin_beta], [cos_beta]) = S::sin_cos_each([beta]);
        let w_11 = theta3_dot + w_2 * cos_beta - w_4 * sin_alpha * sin_beta;
        let w_12 = cos_alpha * self.a;
        let w_13 = w_3 + w_4 * w_12;
        let w_18 = sin_alpha * cos_beta * w_4 + w_2 * sin_beta;
        let w_15 = cos_beta * w_13 - sin_beta * w_14;
        let w_16 = theta1_dot * sin_theta2;
        let w_17 = self.a * w_11 + cos_theta3 * w_15 * S::from_f64(2.0)
            - sin_theta3 * w_16 * w_6;
        let w_25 = cos_theta3 * w_16 * w_12 + sin_theta3 * w_15;
        let w_19 = w_18 * cos_theta3 - sin_alpha * sin_theta3 * w_16;
        let w_20 = self.a * w_19 + w_13 * sin_beta * S::from_f64(2.0)
            + w_14 * cos_beta * S::from_f64(2.0);
        let w_21 = w * (w_7 * w_7 + w_10 * w_10 + w_17 * w_17 + w_20 * w_20);
        let w_26 = sin_alpha * cos_theta3 * w_16 + w_18 * sin_theta3;
        let w_22 = S::from_f64(0.5) * self.J;
        let a_squared = self.a * self.a;
        let sin_alpha_squared = sin_alpha * sin_alpha;
        let w_23 = S::from_f64(0.5) * self.m;
        let w_24 = theta1_dot * theta1_dot
            * (w_22 + a_squared * w + sin_alpha_squared * w_22
                + sin_theta2 * sin_theta2
                    * (a_squared * cos_alpha * cos_alpha * w_23
                        - self.J * S::from_f64(0.49) * sin_alpha_squared));
        w_21 + w_22 * (w_2 * w_2 + w_19 * w_19 + w_11 * w_11) + w_24 + w_25 * w_25 * w_23
            + w_26 * w_26 * self.J * S::from_f64(0.01)
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 27 additions, 77 multiplications, 1 division, 5 sine-cosine pairs, 1 other function.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 5],
    ) -> S {
        let [theta1, theta2, theta3] = *q;
        let [theta1_dot, theta2_dot, theta3_dot] = *qd;
        let w = self.m * S::from_f64(0.5);
        let (
            [sin_alpha,
            sin_theta2,
            sin_theta1,
            sin_theta3,
            ],
            [cos_alpha,
            cos_theta2,
            cos_theta1,
            cos_theta3,
            ],
        ) = S::sin_cos_each([self.alpha, theta2, theta1, theta3]);
        let w_2 = cos_alpha * self.g;
        let w_3 = self.g * sin_theta1;
        let w_4 = cos_theta2 * cos_theta1 * w_2 - sin_theta2 * w_3;
        let w_13 = cos_theta2 * w_3 + sin_theta2 * cos_theta1 * w_2;
        let w_5 = theta2_dot + theta1_dot * cos_alpha;
        let w_6 = self.b * w_5;
        let w_7 = theta1_dot * cos_theta2;
        let w_8 = self.a * S::from_f64(2.0);
        let w_9 = cos_alpha * w_8;
        let w_10 = self.b * sin_alpha;
        let beta = (w_10 / self.a).asin();
        let ([sin_beta], [cos_beta]) = S::sin_cos_each([beta]);
        let w_16 = cos_theta2 * w_10;
        let w_11 = self.g * sin_alpha;
        let w_12 = cos_beta * w_4 - cos_theta1 * sin_beta * w_11;
        let w_14 = self.a * cos_alpha;
        let w_15 = w_6 + w_14 * w_7;
        let w_17 = theta1_dot * (self.a * sin_alpha + w_16);
        let w_18 = cos_beta * w_15 - sin_beta * w_17;
        let w_19 = theta1_dot * sin_theta2;
        let w_21 = self.a
            * (cos_theta3 * (w_7 * sin_alpha * cos_beta + w_5 * sin_beta)
                - sin_theta3 * sin_alpha * w_19) + w_15 * sin_beta * S::from_f64(2.0)
            + w_17 * cos_beta * S::from_f64(2.0);
        let w_20 = self.a * (theta3_dot + cos_beta * w_5 - w_7 * sin_alpha * sin_beta)
            + cos_theta3 * w_18 * S::from_f64(2.0) - sin_theta3 * w_19 * w_9;
        let w_22 = w
            * (w_4 * (w_6 + w_7 * w_9) + (cos_theta3 * w_12 - w_13 * sin_theta3) * w_20
                + (sin_beta * w_4 + cos_theta1 * cos_beta * w_11) * w_21);
        let w_24 = self.m * (cos_theta3 * w_14 * w_19 + sin_theta3 * w_18)
            * (w_13 * cos_theta3 + sin_theta3 * w_12);
        let w_23 = theta1_dot
            * (sin_theta2 * w_13 * self.a * self.m * cos_alpha
                + cos_theta1 * self.a * self.g * w);
        w_22 + w_23 + w_24
            + cos_theta1 * theta1_dot * (w_16 + sin_alpha * w_8) * self.g * sin_alpha * w
    }
    /// Outputs, 2, in SI units.
    ///
    /// Operations: 2 additions, 6 multiplications, 1 square root, 2 other functions.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 5],
    ) -> BennettOutputs<S> {
        let [theta1, theta2, _] = *q;
        let [lambda_closure_x, lambda_closure_y, lambda_closure_z, _, _] = *lambda;
        [
            (S::from_f64(0.5) * theta1).tan() * (S::from_f64(0.5) * theta2).tan(),
            (lambda_closure_x * lambda_closure_x + lambda_closure_y * lambda_closure_y
                + lambda_closure_z * lambda_closure_z)
                .sqrt(),
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 1, in SI units per second.
    ///
    /// Operations: 3 additions, 9 multiplications, 2 other functions.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
    ) -> BennettOutputRates<S> {
        let [theta1, theta2, _] = *q;
        let [theta1_dot, theta2_dot, _] = *qd;
        let w = (S::from_f64(0.5) * theta2).tan();
        let w_2 = (S::from_f64(0.5) * theta1).tan();
        [
            S::from_f64(0.5)
                * (theta1_dot * w * (S::from_f64(1.0) + w_2 * w_2)
                    + w_2 * theta2_dot * (S::from_f64(1.0) + w * w)),
        ]
            .into()
    }
    /// `left - right` of each event, 0, in SI units: zero when it happens.
    ///
    /// Operations: none.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 5],
    ) -> [S; 0] {
        []
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 39 additions, 45 multiplications, 1 division, 5 sine-cosine pairs, 1 other function.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 3]) -> [S; 36] {
        let [theta1, theta2, theta3] = *q;
        let (
            [sin_theta1,
            sin_theta2,
            sin_alpha,
            sin_theta3,
            ],
            [cos_theta1,
            cos_theta2,
            cos_alpha,
            cos_theta3,
            ],
        ) = S::sin_cos_each([theta1, theta2, self.alpha, theta3]);
        let P2_x = self.a * cos_theta1;
        let P2_y = self.a * sin_theta1;
        let w = cos_theta1 * cos_theta2;
        let w_2 = sin_theta1 * sin_theta2;
        let w_3 = w - cos_alpha * w_2;
        let w_12 = cos_alpha * w - w_2;
        let w_4 = self.b * w_3;
        let P3_x = P2_x + w_4;
        let w_5 = sin_theta1 * cos_theta2;
        let w_6 = cos_theta1 * sin_theta2;
        let w_7 = w_5 + cos_alpha * w_6;
        let w_11 = w_6 + cos_alpha * w_5;
        let w_8 = self.b * w_7;
        let P3_y = P2_y + w_8;
        let w_9 = self.b * sin_alpha;
        let P3_z = sin_theta2 * w_9;
        let beta = (w_9 / self.a).asin();
        let ([sin_beta], [cos_beta]) = S::sin_cos_each([beta]);
        let w_10 = sin_alpha * sin_beta;
        let w_13 = sin_alpha * S::from_f64(0.05);
        let w_14 = sin_theta1 * w_13;
        let w_15 = cos_theta1 * w_13;
        let w_16 = cos_alpha * S::from_f64(0.05);
        let w_17 = sin_beta * S::from_f64(0.05);
        let w_18 = w_11 * w_17;
        let w_21 = w_12 * w_17;
        let w_19 = cos_beta * w_13;
        let w_24 = cos_theta2 * sin_beta * w_13;
        let w_20 = sin_theta1 * w_19;
        let w_22 = cos_theta1 * w_19;
        let w_23 = cos_beta * w_16;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            -self.b,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            P2_x,
            P2_y,
            S::from_f64(0.0),
            P2_x,
            P2_y,
            S::from_f64(0.0),
            P3_x,
            P3_y,
            P3_z,
            P3_x,
            P3_y,
            P3_z,
            w_4
                + self.a
                    * (cos_theta1
                        + (w_3 * cos_theta3
                            + (sin_theta1 * w_10 - cos_beta * w_11) * sin_theta3)),
            w_8
                + self.a
                    * (sin_theta1
                        + (w_7 * cos_theta3
                            + sin_theta3 * (cos_beta * w_12 - cos_theta1 * w_10))),
            P3_z
                + self.a
                    * (sin_theta2 * sin_alpha * cos_theta3
                        + sin_theta3
                            * (cos_alpha * sin_beta
                                + cos_theta2 * sin_alpha * cos_beta)),
            P2_x - w_14,
            P2_y + w_15,
            -w_16,
            P2_x + w_14,
            P2_y - w_15,
            w_16,
            P2_x + w_4 - w_18 - w_20,
            P2_y + w_8 + w_21 + w_22,
            P3_z - w_23 + w_24,
            P2_x + w_4 + w_18 + w_20,
            P2_y + w_8 - w_21 - w_22,
            P3_z + w_23 - w_24,
        ]
    }
    /// Declared start: values or guesses of the coordinates (3), and speeds (3), in SI units; 0 where nothing is declared.
    ///
    /// Operations: 2 additions, 2 multiplications.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        let w = S::from_f64(0.3333333333333333) * S::from_f64(::core::f64::consts::PI);
        sim_kernel::Initial {
            positions: [
                w,
                -(S::from_f64(::core::f64::consts::PI)
                    * S::from_f64(0.8888888888888888)),
                -w,
            ],
            speeds: [self.speed, S::from_f64(0.0), S::from_f64(0.0)],
        }
    }
    /// [`BennettPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 5]> {
        self.prepare().dynamics(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> BennettPrepared<S> {
    /// Accelerations (3), multipliers (5) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 353 additions, 588 multiplications, 8 divisions, 3 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 5]> {
        let [theta1, theta2, theta3] = *q;
        let [theta1_dot, theta2_dot, theta3_dot] = *qd;
        let (
            [sin_theta2,
            sin_theta3,
            sin_theta1,
            ],
            [cos_theta2,
            cos_theta3,
            cos_theta1,
            ],
        ) = S::sin_cos_each([theta2, theta3, theta1]);
        let w = self.k_6 + cos_theta2 * self.k_9;
        let theta1_dot_squared = theta1_dot * theta1_dot;
        let w_2 = sin_theta2 * theta1_dot_squared;
        let w_3 = self.k_39 * w_2;
        let w_4 = self.a * theta1_dot_squared + sin_theta1 * self.g;
        let w_5 = S::from_f64(2.0) * w_4;
        let w_6 = cos_theta2 * (cos_theta1 * self.k_38 - w_3) - sin_theta2 * w_5;
        let w_22 = cos_theta2 * (cos_theta1 * self.k_41 - w_3) - sin_theta2 * w_4;
        let w_7 = cos_theta2 * self.k;
        let w_8 = w_7 + self.k_10;
        let w_9 = self.cos_alpha * theta1_dot;
        let w_10 = theta2_dot + w_9;
        let w_11 = self.b * self.sin_alpha * sin_theta2 * theta1_dot
            * (theta2_dot + w_10);
        let w_12 = self.k_4 - cos_theta2 * self.k_5;
        let w_13 = self.k_6 + cos_theta2 * self.k_7;
        let w_14 = self.k_8 + w_7;
        let w_15 = self.cos_beta * w_13 - self.sin_beta * w_14;
        let w_16 = sin_theta2 * sin_theta3;
        let w_17 = self.a * w_12 + S::from_f64(2.0) * cos_theta3 * w_15
            - w_16 * self.k_9;
        let w_18 = self.b
            * (w_10 * w_10
                + self.sin_alpha_squared * theta1_dot_squared * cos_theta2 * cos_theta2);
        let w_19 = sin_theta2 * cos_theta1;
        let w_20 = w_19 * self.k_41;
        let w_21 = w_18 + w_20 + cos_theta2 * w_4;
        let w_23 = w_11 + cos_theta1 * self.k_42;
        let w_24 = self.cos_beta * w_22 - self.sin_beta * w_23;
        let w_25 = cos_theta2 * self.k_2;
        let w_26 = w_25 * theta1_dot + self.sin_beta * w_10;
        let w_35 = self.k_3 + w_25;
        let w_27 = self.sin_alpha * theta1_dot;
        let w_28 = cos_theta3 * w_26 - w_16 * w_27;
        let w_29 = sin_theta2 * cos_theta3;
        let w_30 = w_29 * w_27 + sin_theta3 * w_26;
        let w_54 = self.k_7 * w_29 + sin_theta3 * w_15;
        let w_31 = w_28 * w_30;
        let w_32 = theta1_dot * theta2_dot;
        let w_44 = sin_theta2
            * ((w_18 + w_19 * self.k_38 + cos_theta2 * w_5) * self.k_47
                - cos_theta2 * (w_32 * self.k_43 + theta1_dot_squared * self.k_45));
        let w_33 = sin_theta2 * w_32;
        let w_34 = S::from_f64(2.0) * (sin_theta3 * w_21 - cos_theta3 * w_24)
            + self.a * (w_31 + self.k_5 * w_33);
        let w_36 = w_35 * cos_theta3 - self.sin_alpha * w_16;
        let closure_z_by_theta3 = self.a * w_36;
        let w_37 = closure_z_by_theta3 + w_13 * self.k_11 + w_14 * self.k_12;
        let w_38 = self.k_5 * theta1_dot;
        let w_39 = theta3_dot + self.cos_beta * w_10 - cos_theta2 * w_38;
        let w_55 = S::from_f64(2.0) * (sin_theta3 * w_24 + cos_theta3 * w_21)
            + self.a * (w_28 * w_28 + w_39 * w_39);
        let w_40 = cos_theta2 * sin_theta3;
        let w_41 = self.k_2 * w_29 + self.sin_alpha * w_40;
        let w_42 = self.a * (w_30 * (theta3_dot + w_39) + w_32 * w_41) + self.k_12 * w_23
            + self.k_11 * w_22;
        let w_43 = self.k_14
            * (w * w_6 + w_8 * (cos_theta1 * self.k_40 + w_11) - w_17 * w_34
                + w_37 * w_42);
        let w_45 = theta2_dot * w_41;
        let w_46 = w_30 * w_39 * self.k_35
            + (theta1_dot * w_45 + theta3_dot * w_30) * self.k_36;
        let w_47 = self.k_35 * w_31 + self.k_37 * w_33;
        let w_48 = cos_theta2 * sin_theta2 * theta1_dot
            * (w_10 * self.k_33 + theta2_dot * self.k_34) * self.k_44;
        let w_49 = self.sin_alpha * w_29;
        let w_50 = w_49 + w_35 * sin_theta3;
        let w_51 = cos_theta2 * cos_theta3;
        let w_52 = self.sin_alpha * w_51 - self.k_2 * w_16;
        let w_53 = theta3_dot * w_28 + w_52 * w_32;
        let rhs_theta1 = w_43 + w_44 + S::from_f64(0.02) * (w_36 * w_46 - w_12 * w_47)
            + w_48 - w_50 * self.k_15 * w_53 + cos_theta1 * self.k_46
            + w_54 * w_55 * self.k_48;
        let closure_z_by_theta2 = w_7 + self.a * w_52;
        let w_56 = self.k_21 + cos_theta3 * self.k_20;
        let w_57 = self.k_18 + cos_theta3 * self.k_19;
        let w_58 = sin_theta3 * (w_55 * self.k_51 - self.k_27 * w_53)
            + self.k_14 * (w_56 * w_42 - w_57 * w_34) - cos_theta2 * self.k_13 * w_2
            + cos_theta3 * w_46 * self.k_49 - w_47 * self.k_50 + self.k_26 * w_6;
        let mass_theta2_theta1 = self.k_22
            + sin_theta3 * (w_54 * self.k_25 + w_50 * self.k_27)
            + self.k_14 * (w_17 * w_57 + w_37 * w_56) + cos_theta3 * w_36 * self.k_23
            + w_12 * self.k_24 + w * self.k_26;
        let w_59 = self.k_14 * (w * w + w_8 * w_8 + w_17 * w_17 + w_37 * w_37);
        let mass_theta1_theta1 = self.k_16 + w_59 + self.J * (w_36 * w_36 + w_12 * w_12)
            + sin_theta2 * sin_theta2 * self.k_17 + self.m * w_54 * w_54
            + w_50 * w_50 * self.k_15;
        let mass_theta3_theta1 = self.J * w_12 + w_17 * self.k_30;
        let inverse_theta1 = S::from_f64(1.0) / mass_theta1_theta1;
        let l_theta2_theta1 = mass_theta2_theta1 * inverse_theta1;
        let rhs_theta2 = w_58 - rhs_theta1 * l_theta2_theta1;
        let w_60 = cos_theta2 * sin_theta1;
        let w_130 = w_20 + w_60 * self.g;
        let w_61 = w_60 + self.cos_alpha * w_19;
        let w_71 = w_19 + self.cos_alpha * w_60;
        let w_62 = cos_theta2 * cos_theta1;
        let w_63 = sin_theta2 * sin_theta1;
        let w_64 = self.cos_alpha * w_62 - w_63;
        let w_65 = self.cos_beta * w_64 - self.k_5 * cos_theta1;
        let w_66 = cos_theta3 * w_61 + sin_theta3 * w_65;
        let w_77 = cos_theta3 * w_65 - sin_theta3 * w_61;
        let minus_closure_x_by_theta1 = self.a * (sin_theta1 + w_66) + self.b * w_61;
        let minus_l_lambda_closure_x_theta1 = minus_closure_x_by_theta1 * inverse_theta1;
        let w_67 = theta1_dot + self.cos_alpha * theta2_dot;
        let w_68 = w_62 * w_10 - sin_theta2 * sin_theta1 * w_67;
        let w_76 = w_62 * w_67 - w_63 * w_10;
        let w_69 = cos_theta1 * w_38 - self.cos_beta * w_68;
        let w_70 = w_62 - self.cos_alpha * w_63;
        let w_128 = w_62 * self.k_41 - w_63 * self.g;
        let w_72 = self.k_5 * sin_theta1 - self.cos_beta * w_71;
        let w_73 = cos_theta3 * w_70 + sin_theta3 * w_72;
        let w_85 = cos_theta3 * w_72 - sin_theta3 * w_70;
        let w_74 = w_61 * theta1_dot + w_71 * theta2_dot;
        let w_75 = self.a * theta3_dot;
        let w_89 = theta2_dot
            * (sin_theta2 * self.k * theta2_dot
                + self.a * (theta2_dot * (w_49 + self.k_2 * w_40) + theta3_dot * w_41))
            + w_75 * (w_45 + w_50 * theta3_dot);
        let w_78 = w_71 * theta1_dot + w_61 * theta2_dot;
        let w_79 = self.cos_beta * w_78 - sin_theta1 * w_38;
        let w_80 = cos_theta1 * theta1_dot;
        let w_81 = theta1_dot
            * (self.a
                * (cos_theta3 * w_76 + w_77 * theta3_dot - sin_theta3 * w_79 + w_80)
                + self.b * w_76);
        let w_82 = self.cos_beta * theta3_dot;
        let w_83 = theta2_dot
            * (self.b * w_68
                + self.a
                    * (cos_theta3 * (w_68 + w_70 * w_82)
                        - sin_theta3 * (w_71 * theta3_dot + self.cos_beta * w_74)));
        let w_88 = theta2_dot
            * (self.b * w_78
                + self.a
                    * (cos_theta3 * (w_78 + w_61 * w_82)
                        + sin_theta3 * (w_64 * theta3_dot + self.cos_beta * w_76)));
        let mass_theta2_theta2 = self.k_28 + self.k_14 * (w_57 * w_57 + w_56 * w_56)
            + sin_theta3 * sin_theta3 * self.k_29;
        let pivot_theta2 = mass_theta2_theta2 - mass_theta2_theta1 * l_theta2_theta1;
        let inverse_theta2 = S::from_f64(1.0) / pivot_theta2;
        let w_84 = self.cos_beta * sin_theta3;
        let k_lambda_closure_x_theta2 = mass_theta2_theta1
            * minus_l_lambda_closure_x_theta1
            - (self.b * w_71 + self.a * (cos_theta3 * w_71 + w_70 * w_84));
        let closure_y_by_theta1 = self.a * (cos_theta1 + w_73) + self.b * w_70;
        let l_lambda_closure_x_theta2 = inverse_theta2 * k_lambda_closure_x_theta2;
        let l_theta3_theta1 = mass_theta3_theta1 * inverse_theta1;
        let k_theta3_theta2 = self.k_24 + w_57 * self.k_30
            - mass_theta2_theta1 * l_theta3_theta1;
        let l_theta3_theta2 = inverse_theta2 * k_theta3_theta2;
        let minus_rhs_theta3 = w_31 * self.k_52 + w_33 * self.k_53 + self.k_30 * w_34
            + rhs_theta1 * l_theta3_theta1 + l_theta3_theta2 * rhs_theta2;
        let pivot_theta3 = self.mass_theta3_theta3 - mass_theta3_theta1 * l_theta3_theta1
            - k_theta3_theta2 * l_theta3_theta2;
        let inverse_theta3 = S::from_f64(1.0) / pivot_theta3;
        let k_lambda_closure_x_theta3 = self.a * w_85
            + mass_theta3_theta1 * minus_l_lambda_closure_x_theta1
            - k_theta3_theta2 * l_lambda_closure_x_theta2;
        let l_lambda_closure_x_theta3 = inverse_theta3 * k_lambda_closure_x_theta3;
        let rhs_lambda_closure_x = rhs_theta1 * minus_l_lambda_closure_x_theta1
            - ((cos_theta3 * w_69 - w_73 * theta3_dot + sin_theta3 * w_74) * w_75 - w_81
                - w_83) - l_lambda_closure_x_theta2 * rhs_theta2
            + l_lambda_closure_x_theta3 * minus_rhs_theta3;
        let w_86 = sin_theta1 * theta1_dot;
        let w_87 = theta1_dot
            * (self.a
                * (cos_theta3 * w_74 - w_85 * theta3_dot - sin_theta3 * w_69 + w_86)
                + self.b * w_74);
        let l_lambda_closure_y_theta1 = closure_y_by_theta1 * inverse_theta1;
        let k_lambda_closure_y_theta2 = self.b * w_64
            + self.a * (cos_theta3 * w_64 - w_61 * w_84)
            - mass_theta2_theta1 * l_lambda_closure_y_theta1;
        let l_lambda_closure_y_theta2 = inverse_theta2 * k_lambda_closure_y_theta2;
        let k_lambda_closure_y_theta3 = self.a * w_77
            - mass_theta3_theta1 * l_lambda_closure_y_theta1
            - k_theta3_theta2 * l_lambda_closure_y_theta2;
        let l_lambda_closure_y_theta3 = inverse_theta3 * k_lambda_closure_y_theta3;
        let minus_pivot_lambda_closure_x = minus_closure_x_by_theta1
            * minus_l_lambda_closure_x_theta1
            + k_lambda_closure_x_theta2 * l_lambda_closure_x_theta2
            + k_lambda_closure_x_theta3 * l_lambda_closure_x_theta3;
        let minus_inverse_lambda_closure_x = S::from_f64(1.0)
            / minus_pivot_lambda_closure_x;
        let k_lambda_closure_y_lambda_closure_x = minus_closure_x_by_theta1
            * l_lambda_closure_y_theta1
            - k_lambda_closure_x_theta2 * l_lambda_closure_y_theta2
            - k_lambda_closure_x_theta3 * l_lambda_closure_y_theta3;
        let minus_l_lambda_closure_y_lambda_closure_x = minus_inverse_lambda_closure_x
            * k_lambda_closure_y_lambda_closure_x;
        let rhs_lambda_closure_y = w_87 + w_88
            + w_75 * (cos_theta3 * w_79 + w_66 * theta3_dot + sin_theta3 * w_76)
            - rhs_theta1 * l_lambda_closure_y_theta1
            - l_lambda_closure_y_theta2 * rhs_theta2
            + l_lambda_closure_y_theta3 * minus_rhs_theta3
            + minus_l_lambda_closure_y_lambda_closure_x * rhs_lambda_closure_x;
        let l_lambda_closure_z_theta2 = closure_z_by_theta2 * inverse_theta2;
        let k_lambda_closure_z_theta3 = closure_z_by_theta3
            - k_theta3_theta2 * l_lambda_closure_z_theta2;
        let l_lambda_closure_z_theta3 = inverse_theta3 * k_lambda_closure_z_theta3;
        let minus_k_lambda_closure_z_lambda_closure_x = k_lambda_closure_x_theta2
            * l_lambda_closure_z_theta2
            + k_lambda_closure_x_theta3 * l_lambda_closure_z_theta3;
        let l_lambda_closure_z_lambda_closure_x = minus_inverse_lambda_closure_x
            * minus_k_lambda_closure_z_lambda_closure_x;
        let w_90 = closure_y_by_theta1 * l_lambda_closure_y_theta1
            + k_lambda_closure_y_theta2 * l_lambda_closure_y_theta2
            + k_lambda_closure_y_theta3 * l_lambda_closure_y_theta3;
        let pivot_lambda_closure_y = k_lambda_closure_y_lambda_closure_x
            * minus_l_lambda_closure_y_lambda_closure_x - w_90;
        let inverse_lambda_closure_y = S::from_f64(1.0) / pivot_lambda_closure_y;
        let minus_k_lambda_closure_z_lambda_closure_y = k_lambda_closure_y_theta2
            * l_lambda_closure_z_theta2
            + k_lambda_closure_y_theta3 * l_lambda_closure_z_theta3
            + k_lambda_closure_y_lambda_closure_x * l_lambda_closure_z_lambda_closure_x;
        let minus_l_lambda_closure_z_lambda_closure_y = inverse_lambda_closure_y
            * minus_k_lambda_closure_z_lambda_closure_y;
        let rhs_lambda_closure_z = w_89 - l_lambda_closure_z_theta2 * rhs_theta2
            + l_lambda_closure_z_theta3 * minus_rhs_theta3
            - l_lambda_closure_z_lambda_closure_x * rhs_lambda_closure_x
            + minus_l_lambda_closure_z_lambda_closure_y * rhs_lambda_closure_y;
        let w_91 = self.cos_alpha * w_51 - w_16 * self.k_4;
        let w_92 = cos_theta3 * self.k_4 - self.k_5;
        let w_93 = self.cos_alpha * w_16;
        let w_94 = cos_theta2 * w_92 - w_93;
        let w_106 = theta3_dot * (self.k_4 * w_51 - w_93) + w_91 * theta2_dot;
        let w_95 = w_91 * theta3_dot + w_94 * theta2_dot;
        let w_96 = self.k_3 * cos_theta3;
        let w_97 = self.cos_alpha * w_94 - self.sin_alpha * (self.k_2 + w_96);
        let w_98 = self.cos_alpha * w_40;
        let w_99 = w_98 + sin_theta2 * w_92;
        let w_100 = self.k_4 * w_40 + self.cos_alpha * w_29;
        let w_101 = w_99 * theta2_dot + w_100 * theta3_dot;
        let w_105 = theta2_dot
            * (self.sin_beta
                * (self.cos_alpha * (cos_theta1 * w_95 - w_99 * w_86) + w_94 * w_80
                    - sin_theta1 * w_101) + self.k_2 * w_95);
        let w_102 = sin_theta3 * theta3_dot;
        let w_103 = self.sin_beta * theta1_dot;
        let w_104 = (cos_theta1 * (w_95 + w_97 * theta1_dot)
            - sin_theta1
                * (self.cos_alpha * w_101 - self.k_31 * w_102 + w_99 * theta1_dot))
            * w_103;
        let minus_closure_m1_by_theta1 = self.sin_beta
            * (cos_theta1 * w_99 + sin_theta1 * w_97);
        let w_107 = cos_theta3 * theta3_dot;
        let w_108 = self.cos_alpha * w_100 - sin_theta3 * self.k_31;
        let w_109 = cos_theta1
            * (self.cos_alpha * w_106 - self.k_31 * w_107 + w_91 * theta1_dot)
            - sin_theta1
                * (theta3_dot * (w_98 + self.k_4 * w_29) + w_100 * theta2_dot
                    + w_108 * theta1_dot);
        let w_110 = w_104 + w_105
            + theta3_dot
                * (self.sin_beta * w_109
                    + self.cos_beta * (self.sin_alpha * w_106 + self.k_32 * w_107));
        let minus_l_lambda_closure_m1_theta1 = minus_closure_m1_by_theta1
            * inverse_theta1;
        let w_111 = self.cos_alpha * cos_theta1;
        let k_lambda_closure_m1_theta2 = mass_theta2_theta1
            * minus_l_lambda_closure_m1_theta1
            - (self.sin_beta * (w_99 * w_111 + sin_theta1 * w_94) + self.k_2 * w_99);
        let l_lambda_closure_m1_theta2 = inverse_theta2 * k_lambda_closure_m1_theta2;
        let k_lambda_closure_m1_theta3 = mass_theta3_theta1
            * minus_l_lambda_closure_m1_theta1
            - (self.sin_beta * (cos_theta1 * w_108 + sin_theta1 * w_91)
                + self.cos_beta * (self.sin_alpha * w_100 + sin_theta3 * self.k_32))
            - k_theta3_theta2 * l_lambda_closure_m1_theta2;
        let l_lambda_closure_m1_theta3 = inverse_theta3 * k_lambda_closure_m1_theta3;
        let minus_k_lambda_closure_m1_lambda_closure_x = minus_closure_x_by_theta1
            * minus_l_lambda_closure_m1_theta1
            + k_lambda_closure_x_theta2 * l_lambda_closure_m1_theta2
            + k_lambda_closure_x_theta3 * l_lambda_closure_m1_theta3;
        let l_lambda_closure_m1_lambda_closure_x = minus_inverse_lambda_closure_x
            * minus_k_lambda_closure_m1_lambda_closure_x;
        let k_lambda_closure_m1_lambda_closure_y = closure_y_by_theta1
            * minus_l_lambda_closure_m1_theta1
            - k_lambda_closure_y_theta2 * l_lambda_closure_m1_theta2
            - k_lambda_closure_y_theta3 * l_lambda_closure_m1_theta3
            - k_lambda_closure_y_lambda_closure_x * l_lambda_closure_m1_lambda_closure_x;
        let l_lambda_closure_m1_lambda_closure_y = inverse_lambda_closure_y
            * k_lambda_closure_m1_lambda_closure_y;
        let w_112 = closure_z_by_theta2 * l_lambda_closure_z_theta2
            + k_lambda_closure_z_theta3 * l_lambda_closure_z_theta3;
        let pivot_lambda_closure_z = minus_k_lambda_closure_z_lambda_closure_x
            * l_lambda_closure_z_lambda_closure_x - w_112
            - minus_k_lambda_closure_z_lambda_closure_y
                * minus_l_lambda_closure_z_lambda_closure_y;
        let inverse_lambda_closure_z = S::from_f64(1.0) / pivot_lambda_closure_z;
        let k_lambda_closure_m1_lambda_closure_z = minus_k_lambda_closure_z_lambda_closure_x
            * l_lambda_closure_m1_lambda_closure_x
            - closure_z_by_theta2 * l_lambda_closure_m1_theta2
            - k_lambda_closure_z_theta3 * l_lambda_closure_m1_theta3
            + minus_k_lambda_closure_z_lambda_closure_y
                * l_lambda_closure_m1_lambda_closure_y;
        let l_lambda_closure_m1_lambda_closure_z = inverse_lambda_closure_z
            * k_lambda_closure_m1_lambda_closure_z;
        let rhs_lambda_closure_m1 = w_110 + rhs_theta1 * minus_l_lambda_closure_m1_theta1
            - l_lambda_closure_m1_theta2 * rhs_theta2
            + l_lambda_closure_m1_theta3 * minus_rhs_theta3
            - l_lambda_closure_m1_lambda_closure_x * rhs_lambda_closure_x
            - l_lambda_closure_m1_lambda_closure_y * rhs_lambda_closure_y
            - l_lambda_closure_m1_lambda_closure_z * rhs_lambda_closure_z;
        let w_113 = w_51 - self.cos_beta * w_16;
        let w_118 = w_16 - self.cos_beta * w_51;
        let w_114 = w_29 + self.cos_beta * w_40;
        let w_116 = w_40 + self.cos_beta * w_29;
        let w_115 = self.cos_alpha * w_114 - sin_theta3 * self.k_5;
        let minus_closure_m2_by_theta1 = self.sin_beta
            * (cos_theta1 * w_113 - sin_theta1 * w_115);
        let minus_l_lambda_closure_m2_theta1 = minus_closure_m2_by_theta1
            * inverse_theta1;
        let k_lambda_closure_m2_theta2 = self.sin_beta
            * (sin_theta1 * w_114 - w_111 * w_113) - self.k_2 * w_113
            + mass_theta2_theta1 * minus_l_lambda_closure_m2_theta1;
        let w_117 = w_114 * theta2_dot + w_116 * theta3_dot;
        let w_119 = w_113 * theta2_dot - w_118 * theta3_dot;
        let w_120 = theta2_dot
            * (self.sin_beta
                * (cos_theta1 * (w_114 * theta1_dot + self.cos_alpha * w_117)
                    + sin_theta1 * (w_119 + w_113 * w_9)) + self.k_2 * w_117);
        let w_121 = w_116 * theta2_dot + w_114 * theta3_dot;
        let w_124 = w_103
            * (sin_theta1
                * (self.cos_alpha * w_119 - self.k_5 * w_107 + w_113 * theta1_dot)
                + cos_theta1 * (w_117 + w_115 * theta1_dot));
        let w_122 = self.cos_alpha * w_118 + cos_theta3 * self.k_5;
        let w_123 = self.sin_beta
            * (cos_theta1
                * (self.cos_alpha * w_121 - self.k_5 * w_102 + w_116 * theta1_dot)
                + sin_theta1
                    * (w_113 * theta3_dot - w_118 * theta2_dot - w_122 * theta1_dot));
        let w_125 = w_120
            + theta3_dot
                * (w_123 + self.cos_beta * (self.k_3 * w_102 + self.sin_alpha * w_121))
            + w_124;
        let l_lambda_closure_m2_theta2 = inverse_theta2 * k_lambda_closure_m2_theta2;
        let k_lambda_closure_m2_theta3 = self.sin_beta
            * (sin_theta1 * w_116 + cos_theta1 * w_122)
            - self.cos_beta * (w_96 - self.sin_alpha * w_118)
            + mass_theta3_theta1 * minus_l_lambda_closure_m2_theta1
            - k_theta3_theta2 * l_lambda_closure_m2_theta2;
        let l_lambda_closure_m2_theta3 = inverse_theta3 * k_lambda_closure_m2_theta3;
        let minus_k_lambda_closure_m2_lambda_closure_x = minus_closure_x_by_theta1
            * minus_l_lambda_closure_m2_theta1
            + k_lambda_closure_x_theta2 * l_lambda_closure_m2_theta2
            + k_lambda_closure_x_theta3 * l_lambda_closure_m2_theta3;
        let w_127 = minus_closure_m2_by_theta1 * minus_l_lambda_closure_m2_theta1
            + k_lambda_closure_m2_theta2 * l_lambda_closure_m2_theta2
            + k_lambda_closure_m2_theta3 * l_lambda_closure_m2_theta3;
        let l_lambda_closure_m2_lambda_closure_x = minus_inverse_lambda_closure_x
            * minus_k_lambda_closure_m2_lambda_closure_x;
        let k_lambda_closure_m2_lambda_closure_y = closure_y_by_theta1
            * minus_l_lambda_closure_m2_theta1
            - k_lambda_closure_y_theta2 * l_lambda_closure_m2_theta2
            - k_lambda_closure_y_theta3 * l_lambda_closure_m2_theta3
            - k_lambda_closure_y_lambda_closure_x * l_lambda_closure_m2_lambda_closure_x;
        let l_lambda_closure_m2_lambda_closure_y = inverse_lambda_closure_y
            * k_lambda_closure_m2_lambda_closure_y;
        let k_lambda_closure_m2_lambda_closure_z = minus_k_lambda_closure_z_lambda_closure_x
            * l_lambda_closure_m2_lambda_closure_x
            - closure_z_by_theta2 * l_lambda_closure_m2_theta2
            - k_lambda_closure_z_theta3 * l_lambda_closure_m2_theta3
            + minus_k_lambda_closure_z_lambda_closure_y
                * l_lambda_closure_m2_lambda_closure_y;
        let l_lambda_closure_m2_lambda_closure_z = inverse_lambda_closure_z
            * k_lambda_closure_m2_lambda_closure_z;
        let w_126 = minus_closure_m1_by_theta1 * minus_l_lambda_closure_m1_theta1
            + k_lambda_closure_m1_theta2 * l_lambda_closure_m1_theta2
            + k_lambda_closure_m1_theta3 * l_lambda_closure_m1_theta3;
        let k_lambda_closure_m2_lambda_closure_m1 = minus_k_lambda_closure_m1_lambda_closure_x
            * l_lambda_closure_m2_lambda_closure_x
            - minus_closure_m1_by_theta1 * minus_l_lambda_closure_m2_theta1
            - k_lambda_closure_m1_theta2 * l_lambda_closure_m2_theta2
            - k_lambda_closure_m1_theta3 * l_lambda_closure_m2_theta3
            - k_lambda_closure_m1_lambda_closure_y * l_lambda_closure_m2_lambda_closure_y
            - k_lambda_closure_m1_lambda_closure_z
                * l_lambda_closure_m2_lambda_closure_z;
        let pivot_lambda_closure_m1 = minus_k_lambda_closure_m1_lambda_closure_x
            * l_lambda_closure_m1_lambda_closure_x - w_126
            - k_lambda_closure_m1_lambda_closure_y * l_lambda_closure_m1_lambda_closure_y
            - k_lambda_closure_m1_lambda_closure_z
                * l_lambda_closure_m1_lambda_closure_z;
        let inverse_lambda_closure_m1 = S::from_f64(1.0) / pivot_lambda_closure_m1;
        let l_lambda_closure_m2_lambda_closure_m1 = inverse_lambda_closure_m1
            * k_lambda_closure_m2_lambda_closure_m1;
        let rhs_lambda_closure_m2 = rhs_theta1 * minus_l_lambda_closure_m2_theta1 - w_125
            - l_lambda_closure_m2_theta2 * rhs_theta2
            + l_lambda_closure_m2_theta3 * minus_rhs_theta3
            - l_lambda_closure_m2_lambda_closure_x * rhs_lambda_closure_x
            - l_lambda_closure_m2_lambda_closure_y * rhs_lambda_closure_y
            - l_lambda_closure_m2_lambda_closure_z * rhs_lambda_closure_z
            - l_lambda_closure_m2_lambda_closure_m1 * rhs_lambda_closure_m1;
        let pivot_lambda_closure_m2 = minus_k_lambda_closure_m2_lambda_closure_x
            * l_lambda_closure_m2_lambda_closure_x - w_127
            - k_lambda_closure_m2_lambda_closure_y * l_lambda_closure_m2_lambda_closure_y
            - k_lambda_closure_m2_lambda_closure_z * l_lambda_closure_m2_lambda_closure_z
            - k_lambda_closure_m2_lambda_closure_m1
                * l_lambda_closure_m2_lambda_closure_m1;
        let lambda_closure_m2 = S::from_f64(1.0) / pivot_lambda_closure_m2
            * rhs_lambda_closure_m2;
        let lambda_closure_m1 = inverse_lambda_closure_m1 * rhs_lambda_closure_m1
            - l_lambda_closure_m2_lambda_closure_m1 * lambda_closure_m2;
        let lambda_closure_z = inverse_lambda_closure_z * rhs_lambda_closure_z
            - l_lambda_closure_m1_lambda_closure_z * lambda_closure_m1
            - l_lambda_closure_m2_lambda_closure_z * lambda_closure_m2;
        let lambda_closure_y = inverse_lambda_closure_y * rhs_lambda_closure_y
            + minus_l_lambda_closure_z_lambda_closure_y * lambda_closure_z
            - l_lambda_closure_m1_lambda_closure_y * lambda_closure_m1
            - l_lambda_closure_m2_lambda_closure_y * lambda_closure_m2;
        let lambda_closure_x = minus_l_lambda_closure_y_lambda_closure_x
            * lambda_closure_y - minus_inverse_lambda_closure_x * rhs_lambda_closure_x
            - l_lambda_closure_z_lambda_closure_x * lambda_closure_z
            - l_lambda_closure_m1_lambda_closure_x * lambda_closure_m1
            - l_lambda_closure_m2_lambda_closure_x * lambda_closure_m2;
        let minus_theta3_ddot = inverse_theta3 * minus_rhs_theta3
            + l_lambda_closure_x_theta3 * lambda_closure_x
            + l_lambda_closure_y_theta3 * lambda_closure_y
            + l_lambda_closure_z_theta3 * lambda_closure_z
            + l_lambda_closure_m1_theta3 * lambda_closure_m1
            + l_lambda_closure_m2_theta3 * lambda_closure_m2;
        let theta2_ddot = inverse_theta2 * rhs_theta2
            + l_theta3_theta2 * minus_theta3_ddot
            - l_lambda_closure_x_theta2 * lambda_closure_x
            - l_lambda_closure_y_theta2 * lambda_closure_y
            - l_lambda_closure_z_theta2 * lambda_closure_z
            - l_lambda_closure_m1_theta2 * lambda_closure_m1
            - l_lambda_closure_m2_theta2 * lambda_closure_m2;
        let w_129 = self.cos_beta * w_128 - cos_theta1 * self.k_54;
        let w_131 = cos_theta3 * w_129 - sin_theta3 * w_130;
        let w_133 = cos_theta3 * w_130 + sin_theta3 * w_129;
        let w_132 = self.sin_beta * w_128 + cos_theta1 * self.k_55;
        let w_134 = self.m * (w * w_128 + w_17 * w_131 + w_37 * w_132)
            + cos_theta1 * (self.k_58 + w_8 * self.k_59) + sin_theta2 * w_130 * self.k_56
            + w_54 * w_133 * self.k_57;
        let w_135 = S::from_f64(0.5)
            * (theta1_dot * w_134
                + theta2_dot
                    * (self.m * (w_57 * w_131 + w_56 * w_132)
                        + sin_theta3 * w_133 * self.k_60 + w_128 * self.k_61));
        sim_kernel::Dynamics {
            accelerations: [
                rhs_theta1 * inverse_theta1 - l_theta2_theta1 * theta2_ddot
                    + l_theta3_theta1 * minus_theta3_ddot
                    + minus_l_lambda_closure_x_theta1 * lambda_closure_x
                    - l_lambda_closure_y_theta1 * lambda_closure_y
                    + minus_l_lambda_closure_m1_theta1 * lambda_closure_m1
                    + minus_l_lambda_closure_m2_theta1 * lambda_closure_m2,
                theta2_ddot,
                -minus_theta3_ddot,
            ],
            multipliers: [
                lambda_closure_x,
                lambda_closure_y,
                lambda_closure_z,
                lambda_closure_m1,
                lambda_closure_m2,
            ],
            power: w_135 + theta3_dot * w_131 * self.k_62,
            refused: sim_kernel::pivot_is_refused(mass_theta1_theta1, mass_theta1_theta1)
                | sim_kernel::pivot_is_refused(pivot_theta2, mass_theta2_theta2)
                | sim_kernel::pivot_is_refused(pivot_theta3, self.mass_theta3_theta3)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_closure_x,
                    minus_pivot_lambda_closure_x,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_closure_y, w_90)
                | sim_kernel::pivot_is_refused(pivot_lambda_closure_z, w_112)
                | sim_kernel::pivot_is_refused(pivot_lambda_closure_m1, w_126)
                | sim_kernel::pivot_is_refused(pivot_lambda_closure_m2, w_127),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Bennett<S> {
    type Q = [S; 3];
    type L = [S; 5];
    type Z = [S; 8];
    type QQ = [[S; 3]; 3];
    type LQ = [[S; 3]; 5];
    type LL = [[S; 5]; 5];
    type ZZ = [[S; 8]; 8];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 7];
    type Outputs = [S; 2];
    type OutputRates = [S; 1];
    type Events = [S; 0];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 36];
    type QP = [[S; 7]; 3];
    type LP = [[S; 7]; 5];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = BennettPrepared<S>;
    type On<T: sim_kernel::Scalar> = Bennett<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "bennett",
        type_name: "Bennett",
        docs: "Bennett's overconstrained linkage, hanging along y from two hinges, its loop cut at the fourth.",
        declaration: "/// Bennett's overconstrained linkage, hanging along y from two hinges, its loop cut at the fourth.\npub Bennett;\n\ncoordinates {\n    /// Turn at the first hinge.\n    theta1 [rad];\n    /// At the second.\n    theta2 [rad];\n    /// At the third.\n    theta3 [rad];\n}\n\nparameters {\n    /// Length of the first and the third bar.\n    a [m] = 0.5;\n    /// Of the second bar and the ground.\n    b [m] = 0.4;\n    /// Twist of the first and the third bar.\n    alpha [deg] = 40;\n    m [kg] = 0.5;\n    /// Moment of inertia of a bar across its axis.\n    J [kg*m^2] = 0.004;\n    g [m/s^2] = 9.81;\n    /// Speed at the first hinge at the start.\n    speed [rad/s] = 0.5;\n}\n\nlet beta = asin(b*sin(alpha)/a);\nlet R1 = rotation(z, theta1);\nlet R2 = R1*rotation(x, alpha)*rotation(z, theta2);\nlet R3 = R2*rotation(x, beta)*rotation(z, theta3);\nlet P2 = R1*[a, 0, 0];\nlet P3 = P2 + R2*[b, 0, 0];\n\nbodies {\n    bar1: mass m at P2/2, inertia [J/50, J, J], attitude R1;\n    bar2: mass m at (P2 + P3)/2, inertia [J/50, J, J], attitude R2;\n    bar3: mass m at P3 + R3*[a/2, 0, 0], inertia [J/50, J, J], attitude R3;\n}\nloads { gravity [0, g, 0]; }\n\njoints {\n    closure: revolute bar3 at [a/2, 0, 0] axis [0, -sin(alpha), cos(alpha)] to ground at [-b, 0, 0] axis [0, sin(beta), cos(beta)];\n}\n\nkernels { }\n\ninitial { theta1 = 60 [deg]; guess theta2 = -160 [deg]; guess theta3 = -60 [deg]; dot(theta1) = speed; }\n\noutputs {\n    /// tan(theta1/2) tan(theta2/2)\n    product = tan(theta1/2)*tan(theta2/2);\n    /// force of the third bar on the ground\n    force [N] = norm(reaction(closure));\n}\n\ndrawing {\n    ground [0, 0, 0], [-b, 0, 0];\n    line [0, 0, 0], P2;\n    line P2, P3;\n    line P3, on(bar3, [a/2, 0, 0]);\n    curve P2 - 0.05 [m]*(R2*[0, 0, 1]), P2 + 0.05 [m]*(R2*[0, 0, 1]);\n    curve P3 - 0.05 [m]*(R3*[0, 0, 1]), P3 + 0.05 [m]*(R3*[0, 0, 1]);\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "theta1",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Turn at the first hinge.",
                },
                speed: sim_kernel::Quantity {
                    name: "theta1_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "theta1_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: true,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "theta2",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "At the second.",
                },
                speed: sim_kernel::Quantity {
                    name: "theta2_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "theta2_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "theta3",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "At the third.",
                },
                speed: sim_kernel::Quantity {
                    name: "theta3_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "theta3_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "a",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of the first and the third bar.",
            },
            sim_kernel::Quantity {
                name: "b",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Of the second bar and the ground.",
            },
            sim_kernel::Quantity {
                name: "alpha",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Twist of the first and the third bar.",
            },
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "J",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Moment of inertia of a bar across its axis.",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "speed",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "Speed at the first hinge at the start.",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "closure_x",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "closure_y",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "closure_z",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "closure_m1",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "closure_m2",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        speed_constraints: &[],
        norm_constraints: &[],
        sparsity: &[],
        conditionals: &[],
        events: &[],
        outputs: &[
            sim_kernel::Quantity {
                name: "product",
                unit: "1",
                factor: 1f64,
                is_length: false,
                docs: "tan(theta1/2) tan(theta2/2)",
            },
            sim_kernel::Quantity {
                name: "force",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "force of the third bar on the ground",
            },
        ],
        rated_outputs: &[0],
        figures: &[
            sim_kernel::Figure {
                name: "product",
                title: "tan(theta1/2) tan(theta2/2)",
                len: 1,
            },
            sim_kernel::Figure {
                name: "force",
                title: "force of the third bar on the ground",
                len: 1,
            },
        ],
        optional_kernels: &[],
        dimension: 3,
        drawing: &[
            sim_kernel::Shape::Ground(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
        ],
    };
    fn defaults() -> Self {
        Self {
            a: S::from_f64(0.5f64),
            b: S::from_f64(0.4f64),
            alpha: S::from_f64(0.6981317007977318f64),
            m: S::from_f64(0.5f64),
            J: S::from_f64(0.004f64),
            g: S::from_f64(9.81f64),
            speed: S::from_f64(0.5f64),
        }
    }
    fn parameters(&self) -> [S; 7] {
        [self.a, self.b, self.alpha, self.m, self.J, self.g, self.speed]
    }
    fn with_parameters(&self, parameters: [S; 7]) -> Self {
        Self {
            a: parameters[0],
            b: parameters[1],
            alpha: parameters[2],
            m: parameters[3],
            J: parameters[4],
            g: parameters[5],
            speed: parameters[6],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Bennett<T> {
        Bennett {
            a: convert(self.a),
            b: convert(self.b),
            alpha: convert(self.alpha),
            m: convert(self.m),
            J: convert(self.J),
            g: convert(self.g),
            speed: convert(self.speed),
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
    fn prepare(&self) -> BennettPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 5]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn mass_matrix(&self, t: S, q: &[S; 3]) -> [[S; 3]; 3] {
        self.mass_matrix(t, q)
    }
    #[inline(always)]
    fn convective_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        self.convective_forces(t, q, qd)
    }
    #[inline(always)]
    fn generalized_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        self.generalized_forces(t, q, qd)
    }
    #[inline(always)]
    fn constraints(&self, t: S, q: &[S; 3]) -> [S; 5] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 3]) -> [S; 5] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 3]) -> [[S; 3]; 5] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 3]) -> [S; 5] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 5] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 3],
    ) -> sim_kernel::ConstraintLinearization<[S; 5], [[S; 3]; 5]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 3], qd: &[S; 3], qdd: &[S; 3], lambda: &[S; 5]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 5],
    ) -> [S; 2] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 3], qd: &[S; 3], qdd: &[S; 3]) -> [S; 1] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 5],
    ) -> [S; 0] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 3]) -> [S; 36] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        self.initial()
    }
}
