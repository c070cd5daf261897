// What a line by minimum deviation always does: every end point, every pattern of the pulse source.
module minimum_deviation_line_props #(
    parameter N = 24
) (
    input wire         clk,
    input wire         en,
    input wire         load,
    input wire [N-1:0] end_x,
    input wire [N-1:0] end_y,
    input wire [1:0]   negative
);
    reg first = 1'b1;
    always @(posedge clk) first <= 1'b0;

    wire [1:0]     pulse, negative_q;
    wire           done;
    wire [2*N+3:0] d_q;
    wire [2*N-1:0] end_q, rest_q;
    wire [N-1:0]   steps;

    // The command of a line.
    wire [N-1:0] longest = end_x > end_y ? end_x : end_y;
    wire [N-1:0] rest_x  = longest - end_x;
    wire [N-1:0] rest_y  = longest - end_y;
    wire [N+1:0] dx      = {2'b00, end_x} + ~{2'b00, rest_x};
    wire [N+1:0] dy      = {2'b00, end_y} + ~{2'b00, rest_y};

    minimum_deviation_line #(.N(N), .AXES(2)) line (
        .i_clk(clk), .i_rst(first), .i_en(en), .i_load(load), .i_end({end_y, end_x}),
        .i_rest({rest_y, rest_x}), .i_d({dy, dx}), .i_steps(longest), .i_negative(negative),
        .o_pulse(pulse), .o_negative(negative_q), .o_done(done), .o_d(d_q), .o_end(end_q),
        .o_rest(rest_q), .o_steps(steps)
    );

    // What the circuit forgets: the longest way, and pulses.
    reg [N-1:0] way = 0, pulses_x = 0, pulses_y = 0;
    wire signed [N+3:0] l   = {4'b0000, way};
    wire signed [N+3:0] x_e = {4'b0000, end_q[N-1:0]};
    wire signed [N+3:0] y_e = {4'b0000, end_q[2*N-1:N]};
    wire signed [N+3:0] x_rest = {4'b0000, rest_q[N-1:0]};
    wire signed [N+3:0] y_rest = {4'b0000, rest_q[2*N-1:N]};
    wire signed [N+3:0] dx_q   = {{2{d_q[N+1]}}, d_q[N+1:0]};
    wire signed [N+3:0] dy_q   = {{2{d_q[2*N+3]}}, d_q[2*N+3:N+2]};
    always @(posedge clk)
        if (first | load) begin
            way      <= first ? 0 : longest;
            pulses_x <= 0;
            pulses_y <= 0;
        end else if (en & ~done) begin
            pulses_x <= pulses_x + {{(N-1){1'b0}}, pulse[0]};
            pulses_y <= pulses_y + {{(N-1){1'b0}}, pulse[1]};
        end

    reg is_loaded = 1'b0;
    always @(posedge clk) is_loaded <= ~first & (load | is_loaded);

    always @* if (!first) begin
        // No pulse after the end, nor without the pulse source.
        assert (!((done | ~en) & pulse != 0));
        if (!is_loaded) assert (done);
        if (is_loaded) begin
            assert (x_e + x_rest == l && y_e + y_rest == l);
            assert (x_e == l || y_e == l);
            // The longest axis is fed on every step: done means at its end, exactly.
            if (x_e == l) assert (pulses_x + steps == way && (done | ~en | pulse[0]));
            if (y_e == l) assert (pulses_y + steps == way && (done | ~en | pulse[1]));
            assert (!(steps > way));
            // D's range: no axis is more than half a pulse behind the line or ahead of it, for D is
            // d + 2|end| - longest - 1, and longest is |end| + REST.
            if (way != 0) begin
                assert (!(dx_q < -x_rest - x_rest) && dx_q < x_e + x_e);
                assert (!(dy_q < -y_rest - y_rest) && dy_q < y_e + y_e);
            end
        end
    end
endmodule
