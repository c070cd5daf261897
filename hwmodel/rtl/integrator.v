// One digital integrator: the carry out of the adder is the pulse.
//
//            +-----+ N   +-------+ carry
//   i_jv --->|     |--/->|       |------> o_carry
//            | sum |     +-------+
//      +---->|     |--N--> JR --+
//      +-------------------------+
//
// The carry is combinational: it belongs to the clock in which it is seen, and the remainder
// register takes the rest of the sum at the edge that ends that clock.
module integrator #(
    parameter N = 24
) (
    input  wire         i_clk,
    input  wire         i_rst,
    input  wire         i_load,
    input  wire [N-1:0] i_preset,
    // accumulate in this clock
    input  wire         i_en,
    input  wire [N-1:0] i_jv,
    output wire         o_carry,
    output reg  [N-1:0] o_jr
);
    wire [N:0] sum = {1'b0, o_jr} + {1'b0, i_jv};

    assign o_carry = sum[N];

    always @(posedge i_clk)
        if (i_rst)
            o_jr <= {N{1'b0}};
        else if (i_load)
            o_jr <= i_preset;
        else if (i_en)
            o_jr <= sum[N-1:0];
endmodule
