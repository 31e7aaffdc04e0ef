// Nanoseconds of Pinocchio's algorithms for one robot, the least mean over 200 rounds of 256 random states: ./pinocchio FILE.urdf fixed|free
#define BOOST_FUSION_INVOKE_MAX_ARITY 12
#include <pinocchio/fwd.hpp>
#include <pinocchio/multibody.hpp>
#include <pinocchio/parsers/urdf.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <chrono>
#include <iostream>
using namespace pinocchio;

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  Model model;
  if (std::string(argv[2]) == "free") pinocchio::urdf::buildModel(argv[1], JointModelFreeFlyer(), model);
  else pinocchio::urdf::buildModel(argv[1], model);
  Data data(model);
  const int states = 256;
  std::vector<Eigen::VectorXd> q, v, tau;
  const Eigen::VectorXd low = Eigen::VectorXd::Constant(model.nq, -1.5), high = Eigen::VectorXd::Constant(model.nq, 1.5);
  for (int i = 0; i < states; i++) {
    q.push_back(randomConfiguration(model, low, high));
    v.push_back(Eigen::VectorXd::Random(model.nv));
    tau.push_back(Eigen::VectorXd::Random(model.nv));
  }
  auto least = [&](auto f) {
    double best = 1e9;
    for (int round = 0; round < 200; round++) {
      auto start = std::chrono::steady_clock::now();
      for (int i = 0; i < states; i++) f(i);
      best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / states * 1e9);
    }
    return best;
  };
  std::cout << argv[1] + std::string(argv[1]).rfind('/') + 1 << ", nv = " << model.nv
            << ": aba " << least([&](int i) { aba(model, data, q[i], v[i], tau[i], Convention::LOCAL); })
            << ", rnea " << least([&](int i) { rnea(model, data, q[i], v[i], tau[i]); })
            << ", crba " << least([&](int i) { crba(model, data, q[i], Convention::LOCAL); })
            << ", derivatives of aba " << least([&](int i) { computeABADerivatives(model, data, q[i], v[i], tau[i]); }) << " ns\n";
}
